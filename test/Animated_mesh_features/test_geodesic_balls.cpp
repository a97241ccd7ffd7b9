// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Geodesic balls against exact geodesics, local heat balls against those of CGAL's class on patches and on the whole
// mesh, Dijkstra against a brute force.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Geodesic_balls/CGAL_heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Dijkstra_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Global_heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/default_ball_radius.h>
#include <CGAL/Animated_mesh_features/IO/read_mesh.h>
#include <CGAL/Animated_mesh_features/Deformation/curvature.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/global_control.h>
#endif

#include <fstream>
#include <limits>
#include <queue>
#include <string>

#ifndef ANIMATED_MESH_FEATURES_TEST_DATA
  #define ANIMATED_MESH_FEATURES_TEST_DATA ""
#endif

namespace Amf = CGAL::Animated_mesh_features;
using namespace test_support;

typedef Amf::Rest_shape Rest_shape;
typedef Rest_shape::Index Index;
typedef std::vector<std::vector<Index>> Balls;

// Runs every n-th task only; the rows of the others stay empty.
struct Some_tasks
{
  std::size_t step;
  template <class Task>
  void operator()(std::size_t number_of_tasks, const Task& task) const
  {
    for (std::size_t i = 0; i < number_of_tasks; i += step) task(i);
  }
};

template <class Policy>
Balls balls_of(const Rest_shape& shape, double radius, const Policy& policy, std::size_t step = 1)
{
  const Amf::Compressed_rows rows = policy(shape, radius, Some_tasks{step});
  Balls balls;
  for (std::size_t v = 0; v < rows.size(); ++v) balls.emplace_back(rows[v].begin(), rows[v].end());
  CHECK(balls.size() == shape.number_of_vertices());
  return balls;
}

bool contains(const std::vector<Index>& ball, Index v)
{
  return std::binary_search(ball.begin(), ball.end(), v);
}

// The length of the shortest paths along edges by relaxing all edges until nothing changes.
std::vector<double> path_lengths(const Rest_shape& shape, Index source)
{
  std::vector<double> length(shape.number_of_vertices(), std::numeric_limits<double>::infinity());
  length[source] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Rest_shape::Edge& e : shape.edges()) {
      const double l = (shape.points()[e.source] - shape.points()[e.target]).norm();
      for (const auto& ab : {std::make_pair(e.source, e.target), std::make_pair(e.target, e.source)})
        if (length[ab.first] + l < length[ab.second]) {
          length[ab.second] = length[ab.first] + l;
          changed = true;
        }
    }
  }
  return length;
}

// Exact geodesic distances from a vertex to all those within `reach` of it along edges, on the part of the surface that
// they span.
class Exact_geodesics
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Patch;
  typedef CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Patch>> Shortest_path;

public:
  Exact_geodesics(const Rest_shape& shape, Index source, double reach)
  {
    std::map<Index, double> near = {{source, 0}};
    typedef std::pair<double, Index> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    queue.emplace(0, source);
    while (!queue.empty()) {
      const Entry top = queue.top();
      queue.pop();
      if (top.first > near[top.second]) continue;
      for (Index w : shape.neighbours()[top.second]) {
        const double d = top.first + (shape.points()[w] - shape.points()[top.second]).norm();
        const auto inserted = near.emplace(w, d);
        if (d > reach || (!inserted.second && inserted.first->second <= d)) {
          if (inserted.second && d > reach) near.erase(inserted.first);
          continue;
        }
        inserted.first->second = d;
        queue.emplace(d, w);
      }
    }
    Patch patch;
    std::map<Index, Patch::Vertex_index> number;
    for (const auto& n : near) {
      const Vec& p = shape.points()[n.first];
      number[n.first] = patch.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
    }
    for (const Rest_shape::Triangle& t : shape.triangles())
      if (near.count(t[0]) && near.count(t[1]) && near.count(t[2]))
        patch.add_face(number[t[0]], number[t[1]], number[t[2]]); // the rim may lose one that touches it in a vertex
    if (patch.number_of_faces() == 0) return;
    Shortest_path paths(patch);
    paths.add_source_point(number[source]);
    for (const auto& n : number) {
      if (patch.is_isolated(n.second)) continue;
      const double d = paths.shortest_distance_to_source_points(n.second).first;
      if (d >= 0) m_distances[n.first] = d;
    }
  }

  // the vertices reached, with their distances
  const std::map<Index, double>& distances() const { return m_distances; }

private:
  std::map<Index, double> m_distances;
};

// How balls differ from a reference.
struct Comparison
{
  std::size_t balls = 0;
  std::size_t common_edges = 0, all_edges = 0;
  std::size_t wrong = 0;
  double sum_off = 0, largest_off = 0; // of vertices wrongly in or out, |exact distance / radius - 1|

  double edges_in_common() const { return double(common_edges) / double(all_edges); }

  void count_edges(const Rest_shape& shape, const std::vector<Index>& a, const std::vector<Index>& b)
  {
    ++balls;
    std::vector<Index> either;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(either));
    for (Index v : either)
      for (Index w : shape.neighbours()[v]) {
        const bool in_a = contains(a, v) && contains(a, w), in_b = contains(b, v) && contains(b, w);
        common_edges += in_a && in_b;
        all_edges += in_a || in_b;
      }
  }

  void count_wrong(double off)
  {
    ++wrong;
    sum_off += off;
    if (!(off <= largest_off)) largest_off = off;
  }

  void print(const std::string& what) const
  {
    std::cout << "  " << what << ": " << balls << " balls, edges in common " << edges_in_common() << ", vertices wrong "
              << wrong << ", off the rim by " << (wrong > 0 ? sum_off / double(wrong) : 0) << ", at most "
              << largest_off << std::endl;
  }
};

// What holds of every ball: it is sorted and has its centre; whatever shortest paths along edges reach is inside,
// whatever is farther in space than the radius is outside.
void check_invariants(const Rest_shape& shape, const Balls& balls, const Balls& dijkstra, double radius)
{
  std::size_t bad = 0, checked = 0;
  for (std::size_t v = 0; v < balls.size(); ++v) {
    const std::vector<Index>& ball = balls[v];
    if (ball.empty()) continue;
    ++checked;
    bad += !std::is_sorted(ball.begin(), ball.end());
    bad += std::adjacent_find(ball.begin(), ball.end()) != ball.end();
    bad += !contains(ball, Index(v));
    bad += !std::includes(ball.begin(), ball.end(), dijkstra[v].begin(), dijkstra[v].end());
    for (Index w : ball) bad += !((shape.points()[w] - shape.points()[v]).norm() <= radius);
  }
  CHECK(checked > 0);
  CHECK(bad == 0);
}

Comparison against_exact(const Rest_shape& shape, const Balls& balls, double radius, std::size_t step)
{
  Comparison result;
  std::size_t met = 0;
  for (std::size_t v = 0; v < balls.size(); ++v) {
    if (balls[v].empty() || shape.neighbours()[v].empty() || met++ % step != 0) continue;
    const Exact_geodesics exact(shape, Index(v), 2.2 * radius);
    std::vector<Index> reference;
    for (const auto& d : exact.distances()) {
      const bool inside = d.second <= radius;
      if (inside) reference.push_back(d.first);
      if (inside != contains(balls[v], d.first)) result.count_wrong(std::abs(d.second / radius - 1));
    }
    // what is not within reach is far away
    for (Index w : balls[v])
      if (!exact.distances().count(w)) result.count_wrong(1.2);
    result.count_edges(shape, balls[v], reference);
  }
  return result;
}

Comparison against_balls(const Rest_shape& shape, const Balls& a, const Balls& b)
{
  Comparison result;
  for (std::size_t v = 0; v < a.size(); ++v)
    if (!a[v].empty() && !b[v].empty()) result.count_edges(shape, a[v], b[v]);
  return result;
}

struct Bounds
{
  double local_edges, local_off;   // local heat balls against exact geodesics
  double global_edges, global_off; // whole-mesh heat balls, likewise
  double both_edges;               // local against whole mesh, and against CGAL's class on patches
};

// `sources`: exact geodesics are computed for every so many vertices; the steps: which share of clusters and of vertices
// get heat balls by CGAL's class.
void compare(const std::string& name, const Rest_shape& shape, double radius, const Bounds& bounds, std::size_t sources,
             std::size_t patch_step = 1, std::size_t global_step = 1)
{
  const Balls dijkstra = balls_of(shape, radius, Amf::Dijkstra_geodesic_balls());
  const Balls local = balls_of(shape, radius, Amf::Heat_method_geodesic_balls());
  const Balls patches = balls_of(shape, radius, Amf::CGAL_heat_method_geodesic_balls(), patch_step);
  const Balls global = balls_of(shape, radius, Amf::Global_heat_method_geodesic_balls(), global_step);
  std::cout << name << ", radius of " << radius / shape.mean_edge_length() << " edges" << std::endl;
  check_invariants(shape, dijkstra, dijkstra, radius);
  check_invariants(shape, local, dijkstra, radius);
  check_invariants(shape, patches, dijkstra, radius);
  check_invariants(shape, global, dijkstra, radius);
  const Comparison e = against_exact(shape, local, radius, sources);
  e.print("local heat against exact ");
  CHECK(e.edges_in_common() > bounds.local_edges);
  CHECK(e.largest_off < bounds.local_off);
  const Comparison p = against_exact(shape, patches, radius, (std::max)(std::size_t(1), sources / patch_step));
  p.print("CGAL patches against exact");
  CHECK(p.edges_in_common() > bounds.local_edges);
  CHECK(p.largest_off < bounds.local_off);
  const Comparison g = against_exact(shape, global, radius, (std::max)(std::size_t(1), sources / global_step));
  g.print("global heat against exact");
  CHECK(g.edges_in_common() > bounds.global_edges);
  CHECK(g.largest_off < bounds.global_off);
  const Comparison b = against_balls(shape, local, global);
  b.print("local against global heat");
  CHECK(b.edges_in_common() > bounds.both_edges);
  const Comparison c = against_balls(shape, local, patches);
  c.print("local against CGAL patches");
  CHECK(c.edges_in_common() > bounds.both_edges);
  const Comparison d = against_exact(shape, dijkstra, radius, sources);
  d.print("Dijkstra against exact   ");
  CHECK(d.edges_in_common() < e.edges_in_common()); // what the heat method is there for
}

void test_known_surfaces()
{
  Random random(21);
  compare("irregular square with border", rest_shape_of(irregular_square(40, random)), 0.1,
          {0.985, 0.06, 0.985, 0.06, 0.985}, 20);
  compare("sphere", rest_shape_of(sphere(4)), 0.3, {0.985, 0.08, 0.985, 0.08, 0.985}, 15);
  Shape graded = irregular_square(40, random, 0.35);
  graded.points = mapped(graded.points, [](const Vec& p) {
    const double x = p[0] * (0.25 + 0.75 * p[0]); // edges from 1/4 to 7/4 of the mean
    return Vec(x, p[1], 0.1 * std::sin(9 * x) * std::cos(7 * p[1]));
  });
  compare("graded waves with border", rest_shape_of(graded), 0.12, {0.975, 0.1, 0.97, 0.1, 0.985}, 20);
  // a sheet folded upon itself: the two halves are nearer to each other than the radius. Few triangles make the bend,
  // across which the heat method is up to 19 % off.
  Shape hairpin = irregular_square(40, random);
  hairpin.points = mapped(hairpin.points, [](const Vec& p) {
    const double straight = 0.46, bend = 1 - 2 * straight, r = bend / pi;
    if (p[0] < straight) return Vec(p[0], p[1], 0);
    if (p[0] > 1 - straight) return Vec(1 - p[0], p[1], 2 * r);
    const double a = (p[0] - straight) / r;
    return Vec(straight + r * std::sin(a), p[1], r * (1 - std::cos(a)));
  });
  Shape ring = irregular_square(40, random), sector = irregular_square(40, random, 0.25);
  ring.points = mapped(ring.points, [](const Vec& p) {
    const double a = 2 * pi * p[0] * 0.98, b = 2 * pi * p[1] * 0.98; // a torus, cut open
    return Vec((1 + 0.4 * std::cos(b)) * std::cos(a), (1 + 0.4 * std::cos(b)) * std::sin(a), 0.4 * std::sin(b));
  });
  compare("torus with a cut", rest_shape_of(ring), 0.4, {0.95, 0.12, 0.95, 0.12, 0.97}, 20);
  sector.points = mapped(sector.points, [](const Vec& p) {
    const double k = std::log(8.), r = std::exp(k * p[0]); // angles stay, edges grow to eight times their length
    return Vec(r * std::cos(k * p[1]), r * std::sin(k * p[1]), 0);
  });
  compare("edges from 1 to 8", rest_shape_of(sector), 0.8, {0.97, 0.15, 0.97, 0.15, 0.97}, 20);
  compare("hairpin", rest_shape_of(hairpin), 0.1, {0.98, 0.25, 0.98, 0.25, 0.985}, 20);
}

void test_components_near_each_other()
{
  Random random(22);
  const double radius = 0.15;
  const Shape sheet = irregular_square(24, random);
  const std::size_t n = sheet.points.size();
  Shape sheets = sheet;
  sheets.add(sheet, Vec(0, 0, 0.001));
  sheets.add(sheet, Vec(0.003, 0, 0.002));
  const Rest_shape one = rest_shape_of(sheet), three = rest_shape_of(sheets);
  const auto check = [&](const auto& policy, bool same_bits) {
    const Balls single = balls_of(one, radius, policy), all = balls_of(three, radius, policy);
    std::size_t leaks = 0, different = 0;
    Comparison alike;
    for (std::size_t v = 0; v < all.size(); ++v) {
      std::vector<Index> ball;
      for (Index w : all[v]) {
        leaks += w / n != v / n;
        ball.push_back(Index(w % n));
      }
      std::sort(ball.begin(), ball.end());
      alike.count_edges(one, ball, single[v % n]);
      different += v < 2 * n && ball != single[v % n];
    }
    if (same_bits) CHECK(different == 0); // a sheet has the balls that it has alone
    CHECK(leaks == 0);
    CHECK(alike.edges_in_common() > 0.99);
  };
  check(Amf::Dijkstra_geodesic_balls(), true);
  check(Amf::Heat_method_geodesic_balls(), true);
  check(Amf::CGAL_heat_method_geodesic_balls(), true);
  check(Amf::Global_heat_method_geodesic_balls(), false);
}

// Triangles split by points next to an edge, or on it: slivers and triangles of no area, but the same surface.
void test_slivers()
{
  Random random(23);
  Shape plain = irregular_square(30, random);
  plain.points =
      mapped(plain.points, [](const Vec& p) { return Vec(p[0], p[1], 0.1 * std::sin(8 * p[0] + 3 * p[1])); });
  const double radius = 0.13;
  const std::size_t n = plain.points.size();
  const Rest_shape reference = rest_shape_of(plain);
  for (const double height : {1e-2, 1e-5, 0.}) {
    Shape split = plain;
    for (std::size_t t = 3; t < plain.faces.size(); t += 15) {
      const auto f = plain.faces[t];
      const Vec a = plain.points[std::size_t(f[0])], b = plain.points[std::size_t(f[1])],
                c = plain.points[std::size_t(f[2])];
      const int m = int(split.points.size());
      split.points.push_back((1 - height) * (0.4 * a + 0.6 * b) + height * c);
      split.faces[t] = {{f[1], f[2], m}};
      split.faces.push_back({{f[2], f[0], m}});
      split.faces.push_back({{f[0], f[1], m}});
    }
    split.points.emplace_back(0.5, 0.5, 0); // isolated, though close to the surface
    split.points.emplace_back(3, 3, 3);
    const Rest_shape shape = rest_shape_of(split);
    std::size_t degenerate = 0;
    for (std::size_t t = 0; t < shape.triangles().size(); ++t) degenerate += Amf::is_degenerate(shape, t);
    CHECK((degenerate > 100) == (height == 0));
    const Balls dijkstra = balls_of(shape, radius, Amf::Dijkstra_geodesic_balls());
    const auto check = [&](const std::string& what, const auto& policy, const Bounds& bounds, std::size_t sources) {
      Balls balls = balls_of(shape, radius, policy);
      check_invariants(shape, balls, dijkstra, radius);
      for (std::size_t v = shape.number_of_vertices() - 2; v < shape.number_of_vertices(); ++v)
        CHECK(balls[v] == std::vector<Index>(1, Index(v)));
      balls.resize(n);
      for (std::vector<Index>& ball : balls)
        ball.erase(std::lower_bound(ball.begin(), ball.end(), Index(n)), ball.end());
      const Comparison c = against_exact(reference, balls, radius, sources);
      c.print(what);
      CHECK(c.edges_in_common() > bounds.local_edges);
      CHECK(c.largest_off < bounds.local_off);
    };
    std::cout << "slivers of height " << height << std::endl;
    const Bounds bounds = {0.965, 0.1, 0, 0, 0};
    check("local heat against exact ", Amf::Heat_method_geodesic_balls(), bounds, 20);
    check("CGAL patches against exact", Amf::CGAL_heat_method_geodesic_balls(), bounds, 20);
    check("global heat against exact", Amf::Global_heat_method_geodesic_balls(), bounds, 20);
  }
}

// Two squares that only a triangle of no area connects: it conducts no heat, but it has edges.
void test_degenerate_bridge()
{
  Random random(27);
  const int cells = 16;
  Shape s = irregular_square(cells, random);
  const int n = int(s.points.size());
  s.add(irregular_square(cells, random), Vec(1 + 1. / cells, 0, 0));
  const int row = cells / 2 * (cells + 1), a = row + cells, c = n + row;
  s.points[std::size_t(a)][1] = s.points[std::size_t(c)][1] = 0.5;
  s.points.push_back(0.5 * (s.points[std::size_t(a)] + s.points[std::size_t(c)]));
  s.faces.push_back({{a, c, 2 * n}});
  const Rest_shape shape = rest_shape_of(s);
  const double radius = 0.25;
  const Balls dijkstra = balls_of(shape, radius, Amf::Dijkstra_geodesic_balls());
  const Balls balls = balls_of(shape, radius, Amf::Heat_method_geodesic_balls());
  check_invariants(shape, balls, dijkstra, radius);
  std::size_t across = 0, leaks = 0;
  for (std::size_t v = 0; v < balls.size(); ++v)
    for (Index w : balls[v]) {
      const bool same_square = int(v) != 2 * n && int(w) != 2 * n && (int(v) < n) == (int(w) < n);
      across += !same_square;
      leaks += !same_square && !contains(dijkstra[v], w);
    }
  CHECK(across > 20);
  CHECK(leaks == 0);
}

// A strip of two rows of vertices, bent to three quarters of a circle: over hundreds of edges the heat falls below
// what can be squared, or below any double, and only then the rim of the ball comes, nearer in space than the radius.
void test_long_strip()
{
  const int length = 1500;
  const double radius = 400, circle = length / (1.5 * pi);
  Shape s;
  for (int i = 0; i <= length; ++i)
    for (int k : {0, 1}) {
      const double a = (i + 0.5 * k) / circle;
      s.points.emplace_back(circle * std::cos(a), circle * std::sin(a), k * std::sqrt(0.75));
    }
  for (int i = 0; i < length; ++i) {
    const int a = 2 * i;
    s.faces.push_back({{a, a + 2, a + 1}});
    s.faces.push_back({{a + 1, a + 2, a + 3}});
  }
  const Rest_shape shape = rest_shape_of(s);
  const Balls balls = balls_of(shape, radius, Amf::Heat_method_geodesic_balls());
  const Balls dijkstra = balls_of(shape, radius, Amf::Dijkstra_geodesic_balls());
  check_invariants(shape, balls, dijkstra, radius);
  // along the strip, paths along edges are geodesics but for its width
  const double common = against_balls(shape, balls, dijkstra).edges_in_common();
  std::cout << "strip, radius of " << radius << " edges, against Dijkstra: edges in common " << common << std::endl;
  CHECK(common > 0.99);
}

// The path to a vertex in the ball may lead through one that is outside of it.
void test_detour()
{
  Shape s; // the diagonal of the quadrangle that is no edge is shorter than the radius, all its edges to 1 and 2 longer
  s.points = {Vec(0, 0, 0), Vec(0.8, -0.68, 0), Vec(0.8, 0.68, 0), Vec(0.95, 0, 0), Vec(-1, 0, 0)};
  s.faces = {{{0, 1, 2}}, {{1, 3, 2}}, {{0, 2, 4}}, {{0, 4, 1}}};
  const Rest_shape shape = rest_shape_of(s);
  Amf::Heat_method_geodesic_balls policy;
  policy.cluster_radius = 1e-3; // no other source near by
  for (const double radius : {1.02, 1.04}) {
    const Balls balls = balls_of(shape, radius, policy);
    CHECK(contains(balls[0], 3) && !contains(balls[0], 1) && !contains(balls[0], 2));
  }
}

void test_dijkstra()
{
  Random random(24);
  Shape s = irregular_square(12, random, 0.35);
  s.add(sphere(2), Vec(3, 0, 0));
  s.points.emplace_back(0, 0, 1);
  const Rest_shape shape = rest_shape_of(s);
  for (const double radius : {1e-6, 0.2, 0.7, 100.}) {
    const Balls balls = balls_of(shape, radius, Amf::Dijkstra_geodesic_balls());
    std::size_t different = 0;
    for (std::size_t v = 0; v < s.points.size(); ++v) {
      const std::vector<double> length = path_lengths(shape, Index(v));
      std::vector<Index> expected;
      for (std::size_t w = 0; w < length.size(); ++w)
        if (length[w] <= radius) expected.push_back(Index(w));
      different += balls[v] != expected;
    }
    CHECK(different == 0);
  }
}

// Grouping sources and cutting patches are means to be quick; they must hardly show.
void test_clusters()
{
  Random random(25);
  Shape s = irregular_square(24, random, 0.35);
  s.points = mapped(s.points, [](const Vec& p) { return Vec(p[0], p[1], 0.1 * std::sin(8 * p[0] + 3 * p[1])); });
  const Rest_shape shape = rest_shape_of(s);
  const Balls usual = balls_of(shape, 0.15, Amf::Heat_method_geodesic_balls());
  const auto check = [&](const std::string& what, double size, const auto& policy) {
    const double common = against_balls(shape, usual, balls_of(shape, 0.15, policy)).edges_in_common();
    std::cout << what << " of " << size << ", margins of " << policy.patch_margin
              << " edges, against the default: edges in common " << common << std::endl;
    CHECK(common > 0.985);
  };
  for (const auto& options : {std::make_pair(1e-3, 2.), std::make_pair(2., 2.), std::make_pair(1., 12.)}) {
    Amf::Heat_method_geodesic_balls policy;
    policy.cluster_radius = options.first;
    policy.patch_margin = options.second;
    check("clusters of a radius", policy.cluster_radius, policy);
  }
  for (const auto& options : {std::make_pair(1, 3.), std::make_pair(128, 3.), std::make_pair(64, 12.)}) {
    Amf::CGAL_heat_method_geodesic_balls policy;
    policy.cluster_size = std::size_t(options.first);
    policy.patch_margin = options.second;
    check("CGAL patches for clusters", double(policy.cluster_size), policy);
  }
}

// Without ties, clusters are where they are whatever the numbers of the vertices. Where there are ties, in a regular
// mesh, rounding does not decide them.
void test_renumbering_and_turning()
{
  Random random(28);
  Shape s = irregular_square(40, random, 0.35);
  s.points = mapped(s.points, [&](const Vec& p) { return Vec(p + random.vector(1e-4)); });
  const int n = int(s.points.size());
  std::vector<Index> number;
  for (int i = 0; i < n; ++i) number.push_back(Index((i * 577 + 11) % n));
  Shape t = s;
  for (int i = 0; i < n; ++i) t.points[number[std::size_t(i)]] = s.points[std::size_t(i)];
  for (auto& f : t.faces)
    for (int& v : f) v = int(number[std::size_t(v)]);
  const Rest_shape shape = rest_shape_of(s);
  const Balls a = balls_of(shape, 0.1, Amf::Heat_method_geodesic_balls()),
              b = balls_of(rest_shape_of(t), 0.1, Amf::Heat_method_geodesic_balls());
  std::size_t different = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    std::vector<Index> ball;
    for (Index w : a[v]) ball.push_back(number[w]);
    std::sort(ball.begin(), ball.end());
    different += ball != b[number[v]];
  }
  CHECK(different == 0);

  Shape regular = tube(24, 60, 12);
  regular.points = mapped(regular.points,
                          [](const Vec& p) { return Vec(p[0] + 0.11 * p[1] + 0.02 * p[2], p[1] + 0.07 * p[2], p[2]); });
  const double radius = 0.9;
  const Balls before = balls_of(rest_shape_of(regular), radius, Amf::Heat_method_geodesic_balls());
  for (const double scale : {1., 0.3, 1000.}) {
    const Eigen::AngleAxisd rotation = random.rotation();
    Shape turned = regular;
    turned.points = mapped(regular.points, [&](const Vec& p) { return Vec(scale * (rotation * p)); });
    CHECK(balls_of(rest_shape_of(turned), scale * radius, Amf::Heat_method_geodesic_balls()) == before);
  }
}

template <class Policy>
void test_threads(const Policy& policy)
{
  Random random(26);
  const Rest_shape shape = rest_shape_of(irregular_square(24, random));
  const Balls expected = balls_of(shape, 0.15, policy);
  Amf::Default_visitor visitor;
  for (const std::size_t threads : {1, 2, 3, 5}) {
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
#endif
    const Amf::Compressed_rows rows =
        policy(shape, 0.15,
               Amf::Task_loop<CGAL::Parallel_if_available_tag, Amf::Default_visitor>(
                   visitor, Amf::Stage::GEODESIC_BALLS));
    bool same = rows.size() == expected.size();
    for (std::size_t v = 0; v < expected.size(); ++v)
      same = same && std::equal(expected[v].begin(), expected[v].end(), rows[v].begin(), rows[v].end());
    if (!same) std::cerr << "with " << threads << " threads" << std::endl;
    CHECK(same);
  }
}

void test_scanned_surface(const std::string& file, const Bounds& bounds)
{
  const std::string path = std::string(ANIMATED_MESH_FEATURES_TEST_DATA) + "/" + file;
  if (!std::ifstream(path)) {
    std::cout << file << ": SKIPPED, there is no " << path << std::endl;
    return;
  }
  const Amf::IO::Indexed_mesh mesh = Amf::IO::read_mesh(path);
  Shape s;
  for (const auto& p : mesh.points) s.points.emplace_back(p[0], p[1], p[2]);
  for (const auto& t : mesh.triangles) s.faces.push_back({{int(t[0]), int(t[1]), int(t[2])}});
  const Rest_shape shape = rest_shape_of(s);
  compare(file, shape, 3 * shape.mean_edge_length(), bounds, 40, 8, 100);
}

// The default radius where a part of a mesh is far denser than the rest: balls of a bounded size in the mean, whatever the
// order of the vertices and the unit; elsewhere the plain formula.
void test_radius_in_dense_parts()
{
  const auto plain = [](const Rest_shape& shape) {
    const double h = shape.mean_edge_length();
    return (std::min)((std::max)(0.045 * shape.diameter(), 3 * h), 8 * h);
  };
  const auto mean_size = [](const Rest_shape& shape, double radius) {
    const Amf::Compressed_rows balls = Amf::Dijkstra_geodesic_balls()(shape, radius, Some_tasks{1});
    double sum = 0;
    for (std::size_t v = 0; v < balls.size(); ++v) sum += double(balls[v].size());
    return sum / double(balls.size());
  };
  const Shape dense = regular_plane(60, 60, 1), coarse = regular_plane(6, 6, 300);
  Shape both = dense, other_order = coarse;
  both.add(coarse, Vec(100, 0, 0));
  other_order.add(dense, Vec(-100, 0, 0));
  const Rest_shape shape = rest_shape_of(both);
  const double radius = Amf::default_ball_radius(shape);
  CHECK(radius < plain(shape) && mean_size(shape, plain(shape)) > 1600);
  const double size = mean_size(shape, radius); // fewer than counted: many balls reach beyond the border
  CHECK(size < 1500 && size > 500);
  CHECK_NEAR(Amf::default_ball_radius(rest_shape_of(other_order)), radius, 1e-9 * radius);
  for (Vec& p : both.points) p *= 1e-3;
  CHECK_NEAR(Amf::default_ball_radius(rest_shape_of(both)), 1e-3 * radius, 1e-12 * radius);
  // as dense as this alone, or few vertices: nothing is bounded
  for (const Rest_shape& s : {rest_shape_of(dense), rest_shape_of(coarse), rest_shape_of(sphere(4))})
    CHECK(Amf::default_ball_radius(s) == plain(s));
}

int main()
{
  test_threads(Amf::Dijkstra_geodesic_balls());
  test_threads(Amf::Heat_method_geodesic_balls());
  test_threads(Amf::CGAL_heat_method_geodesic_balls());
  test_threads(Amf::Global_heat_method_geodesic_balls());
#ifndef ANIMATED_MESH_FEATURES_TEST_THREADS_ONLY
  test_dijkstra();
  test_known_surfaces();
  test_components_near_each_other();
  test_slivers();
  test_degenerate_bridge();
  test_long_strip();
  test_detour();
  test_clusters();
  test_radius_in_dense_parts();
  test_renumbering_and_turning();
  test_scanned_surface("horse-rest.obj", {0.93, 0.3, 0.915, 0.35, 0.97});
  test_scanned_surface("horse-rest-irregular.obj", {0.925, 0.3, 0.91, 0.3, 0.93});
#endif
  return test_result();
}
