// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Simplification of animated meshes: what stays the same, what must not be lost, and how far the result is from the
// original.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Applications/choose_poses.h>
#include <CGAL/Animated_mesh_features/Applications/simplification_errors.h>
#include <CGAL/Animated_mesh_features/Applications/simplify_animation.h>

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/global_control.h>
#endif

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

using namespace test_support;
namespace Amf = CGAL::Animated_mesh_features;

typedef Amf::Frame_sequence<Mesh> Sequence;

namespace {

// An animation together with its mesh.
struct Animation
{
  Mesh mesh;
  Sequence sequence;

  Animation(const Shape& shape, const std::vector<Points>& frames)
    : mesh(mesh_of(shape))
    , sequence(mesh, frames_of(frames), .1)
  {
    sequence.set_rest_shape(mesh.points());
  }
  Animation(const Animation&) = delete;
};

Amf::Simplification_options wanted(const std::vector<std::size_t>& vertices)
{
  Amf::Simplification_options o;
  o.vertices = vertices;
  return o;
}

// What `CollapseGuidance` says and nothing more.
struct Archetype_guidance
{
  explicit Archetype_guidance(double w)
    : weight(w)
  {}
  Archetype_guidance(const Archetype_guidance&) = delete;
  double operator()(std::size_t, std::size_t) const { return weight; }
  double weight;
};

template <class Options>
Amf::Simplified_animation simplified(const Animation& a, const Options& o)
{
  return Amf::simplify_animation(a.sequence, o);
}

std::vector<Amf::Simplification_error> errors(const Animation& a, const Amf::Animation_level& level,
                                              bool by_corners = false)
{
  Amf::Simplification_error_options o;
  if (by_corners) o.vertex_of = &level.vertex_of;
  return Amf::simplification_errors(
      a.sequence.rest_shape(), a.sequence.trajectories(), level.triangles,
      level.binding.positions(a.sequence.rest_shape().points()),
      [&](std::size_t f) { return level.binding.positions(a.sequence.trajectories().frame(f)); }, o);
}

// A torus about the z axis.
Shape torus(int around, int along, double radius, double thickness)
{
  Shape s;
  for (int i = 0; i < along; ++i)
    for (int k = 0; k < around; ++k) {
      const double a = 2 * pi * i / along, b = 2 * pi * k / around, r = radius + thickness * std::cos(b);
      s.points.emplace_back(r * std::cos(a), r * std::sin(a), thickness * std::sin(b));
    }
  for (int i = 0; i < along; ++i)
    for (int k = 0; k < around; ++k) {
      const int j = (i + 1) % along, l = (k + 1) % around;
      const int a = i * around + k, b = j * around + k, c = j * around + l, d = i * around + l;
      s.faces.push_back({{a, b, c}});
      s.faces.push_back({{a, c, d}});
    }
  return s;
}

// A flat sheet that is folded along x = 0, the more the later.
std::vector<Points> folded(const Points& flat, std::size_t frames, double most)
{
  std::vector<Points> all;
  for (std::size_t f = 0; f < frames; ++f) {
    const double angle = most * double(f) / double(frames - 1);
    all.push_back(mapped(
        flat, [&](const Vec& p) { return p[0] <= 0 ? p : Vec(p[0] * std::cos(angle), p[1], p[0] * std::sin(angle)); }));
  }
  return all;
}

Shape sheet(int n)
{
  Random random(7);
  Shape s = irregular_square(n, random, .25);
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    s.points[v] = 2 * s.points[v] - Vec(1, 1, 0);
    if (v % std::size_t(n + 1) == std::size_t(n / 2)) s.points[v][0] = 0; // the fold runs along edges
  }
  return s;
}

// A body that stretches, bends and walks away.
std::vector<Points> walking(const Points& rest, std::size_t frames)
{
  std::vector<Points> all;
  for (std::size_t f = 0; f < frames; ++f) {
    const double t = double(f) / double(frames);
    all.push_back(mapped(rest, [&](const Vec& p) {
      const double bend = .4 * std::sin(2 * pi * t) * p[2];
      const Eigen::AngleAxisd turn(bend, Vec(1, 0, 0));
      return Vec(turn * (p.cwiseProduct(Vec(1 + .2 * t, 1, 1 - .1 * t))) + Vec(50 * t, 0, 0));
    }));
  }
  return all;
}

void test_fold()
{
  const Shape s = sheet(20);
  const Animation a(s, folded(s.points, 7, 2.));
  const double diagonal = a.sequence.rest_shape().bounding_box_diagonal();
  const auto all = simplified(a, wanted({12}));
  CHECK(all.poses.size() == 7);
  CHECK(all.levels.size() == 1 && all.levels[0].binding.size() == 12);
  for (const auto& e : errors(a, all.levels[0])) {
    CHECK(e.hausdorff() < 2e-3 * diagonal);
    CHECK(e.normal_angle < 3);
    CHECK(e.turned == 0);
  }
  // At rest nothing tells that there will be a fold.
  Amf::Simplification_options o = wanted({12});
  o.poses = 1;
  o.preferred_poses = {0};
  const auto one = simplified(a, o);
  CHECK(one.poses == std::vector<std::size_t>{0});
  const auto worst = Amf::worst_frame(errors(a, one.levels[0]));
  CHECK(worst.mean() > 10 * Amf::worst_frame(errors(a, all.levels[0])).mean());
  // The corners stay where they are, in every frame: borders count.
  for (std::size_t corner : {std::size_t(0), std::size_t(20), std::size_t(440 - 20), std::size_t(440)}) {
    const Vec p = a.sequence.trajectories().point(corner, 6);
    double nearest = 1;
    for (const Vec& q : all.levels[0].binding.positions(a.sequence.trajectories().frame(6)))
      nearest = (std::min)(nearest, (p - q).norm());
    CHECK(nearest < .02);
  }
}

// Weights sum to 1: whatever moves all vertices affinely moves the result alike; few weights; nested levels.
void test_binding()
{
  const Shape s = sphere(4);
  const Animation a(s, walking(s.points, 5));
  const auto result = simplified(a, wanted({513, 100, 20}));
  CHECK(result.levels.size() == 3);
  Eigen::Matrix3d m;
  m << 1, .5, 0, -.3, 2, .1, 0, .4, -1;
  const Points moved = mapped(s.points, [&](const Vec& p) { return Vec(m * p + Vec(3, 4, 5)); });
  const std::vector<std::size_t> sizes = {513, 100, 20};
  bool all_come_from_theirs = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Amf::Animation_level& level = result.levels[k];
    CHECK(level.binding.size() == sizes[k]);
    double most = 0, sum_error = 0;
    std::size_t support = 0;
    for (std::size_t v = 0; v < level.binding.size(); ++v) {
      double sum = 0;
      for (double w : level.binding.weights(v)) sum += w;
      sum_error = (std::max)(sum_error, std::abs(sum - 1));
      support = (std::max)(support, std::size_t(level.binding.vertices(v).size()));
      const Vec p = level.binding.position(v, s.points), q = level.binding.position(v, moved);
      most = (std::max)(most, (m * p + Vec(3, 4, 5) - q).norm());
    }
    CHECK(sum_error < 1e-12);
    CHECK(most < 1e-11);
    CHECK(support <= 8 && support > 1);
    CHECK(level.vertex_of.size() == s.points.size());
    CHECK(level.triangle_of.size() == level.triangles.size());
    for (std::size_t t = 0; t < level.triangles.size(); ++t) {
      std::set<std::size_t> corners(level.triangles[t].begin(), level.triangles[t].end()), from;
      for (std::size_t u : a.sequence.rest_shape().triangles()[level.triangle_of[t]]) from.insert(level.vertex_of[u]);
      all_come_from_theirs = all_come_from_theirs && corners == from;
    }
    std::set<std::size_t> used(level.vertex_of.begin(), level.vertex_of.end());
    CHECK(used.size() == sizes[k] && *used.rbegin() == sizes[k] - 1);
    if (k == 0) continue;
    std::vector<std::size_t> coarser(sizes[k - 1], sizes[k - 1]);
    bool is_nested = true;
    for (std::size_t v = 0; v < s.points.size(); ++v) {
      std::size_t& c = coarser[result.levels[k - 1].vertex_of[v]];
      if (c == sizes[k - 1]) c = level.vertex_of[v];
      is_nested = is_nested && c == level.vertex_of[v];
    }
    CHECK(is_nested);
  }
  CHECK(all_come_from_theirs);
  // Coarser is worse, and neither is bad: the sagitta of 100 vertices on a sphere is about 1 / 30 of its radius.
  const double fine = Amf::worst_frame(errors(a, result.levels[0])).mean(),
               coarse = Amf::worst_frame(errors(a, result.levels[1])).mean();
  CHECK(fine < .5 * coarse);
  CHECK(coarse < .02);
}

// Genus and number of components stay, no triangle turns over.
void test_topology()
{
  Shape s = torus(16, 40, 3, 1);
  // beside each other: where surfaces cross, what is nearest may look the other way
  s.add(torus(12, 24, 2, .5), Vec(8, 0, 0));
  s.add(sphere(3), Vec(13, 0, 0));
  const Animation a(s, walking(s.points, 6));
  const auto result = simplified(a, wanted({700, 60}));
  for (const Amf::Animation_level& level : result.levels) {
    std::map<std::pair<std::size_t, std::size_t>, int> edges;
    for (const auto& t : level.triangles)
      for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    bool is_closed = true;
    for (const auto& e : edges)
      is_closed = is_closed && e.second == 1 && edges.count({e.first.second, e.first.first}) == 1;
    CHECK(is_closed);
    const long euler = long(level.binding.size()) - long(edges.size() / 2) + long(level.triangles.size());
    CHECK(euler == 2); // two tori and a sphere
  }
  for (const Amf::Animation_level& level : result.levels)
    for (const auto& e : errors(a, level, true)) CHECK(e.turned == 0 && e.turned_in_original == 0);
  for (const auto& e : errors(a, result.levels[0])) CHECK(e.turned == 0);
}

// Refined places bring both surfaces nearer to each other, in no frame by turning a triangle over.
void test_refinement()
{
  const Shape s = torus(24, 60, 3, 1);
  const Animation a(s, walking(s.points, 6));
  Amf::Simplification_options o = wanted({1440, 300, 100});
  o.refinements = 0;
  const auto plain = simplified(a, o);
  o.refinements = 6;
  const auto refined = simplified(a, o);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto before = errors(a, plain.levels[k], true), after = errors(a, refined.levels[k], true);
    CHECK(Amf::worst_frame(after).mean() <= (k == 0 ? 1e-6 : .9 * Amf::worst_frame(before).mean()));
    for (std::size_t f = 0; f < 6; ++f) {
      CHECK(after[f].turned == 0);
      // either surface is near the other one: no vertex went away to where nothing holds it
      CHECK(after[f].mean_to_coarse <= before[f].mean_to_coarse + 1e-6 &&
            after[f].mean_to_original <= before[f].mean_to_original + 1e-6);
    }
  }

  // The mesh itself follows, fixed vertices and borders stay.
  const Shape flat = sheet(12);
  const Animation b(flat, folded(flat.points, 4, 1.));
  o = wanted({40});
  o.fixed_vertices = {84};
  Amf::internal::Collapsed_mesh mesh = Amf::internal::mesh_to_collapse(b.sequence);
  const auto index = get(CGAL::vertex_index, mesh);
  const Amf::Rest_shape& rest = b.sequence.rest_shape();
  Amf::Animation_collapse<Amf::internal::Collapsed_mesh, std::decay_t<decltype(index)>> collapse(
      mesh, index, rest, b.sequence.trajectories(), o);
  const auto cost = collapse.cost();
  const auto placement = collapse.placement();
  const auto filter = collapse.filter();
  std::size_t left = flat.points.size();
  const Amf::Unwatched_simplification watch;
  const Amf::internal::Collapse_counter<Amf::Unwatched_simplification> counter(left, left, 40, watch);
  CGAL::Surface_mesh_simplification::edge_collapse(
      mesh, Amf::internal::Vertex_count_stop(left, 40),
      CGAL::parameters::get_cost(cost).get_placement(placement).filter(filter).visitor(collapse.visitor(counter)));
  const auto points = [&] {
    Points p;
    for (auto v : mesh.vertices()) p.emplace_back(mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]);
    return p;
  };
  const Points before = points();
  for (int i = 0; i < 4; ++i) collapse.refine(mesh, rest);
  CHECK(points() != before);
  std::size_t k = 0;
  for (auto v : mesh.vertices()) {
    Amf::Vertex_binding binding;
    collapse.bind(v, binding);
    const Vec p = binding.position(0, rest.points()), now(mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]);
    CHECK((p - now).norm() < 1e-6);
    if (CGAL::is_border(v, mesh) || std::size_t(v) == 84) CHECK(now == before[k]);
    ++k;
  }
}

// A level of four corners over a sheet, of which another small one lies far above: its height is where the pulls e / (e + s)
// of both are in balance, with s twice the mean distance, well below that of the least squares.
void test_pulls()
{
  const double above = .5;
  Shape s = sheet(12), small = sheet(6);
  for (Vec& p : small.points) p = Vec(.4 * p[0], .4 * p[1], above);
  s.add(small, Vec(0, 0, 0));
  const Amf::Rest_shape rest = rest_shape_of(s);
  const std::array<Amf::Rest_shape::Index, 4> corners = {{0, 12, 168, 156}};
  std::vector<Amf::Rest_shape::Index> survivors;
  for (const Vec& p : s.points) {
    const auto nearer = [&](auto c, auto d) { return (s.points[c] - p).norm() < (s.points[d] - p).norm(); };
    survivors.push_back(*std::min_element(corners.begin(), corners.end(), nearer));
  }
  const Amf::internal::Place_refinement level(
      rest, {{{corners[0], corners[1], corners[2]}}, {{corners[0], corners[2], corners[3]}}}, survivors);
  Amf::internal::Pose_positions original(s.points.size(), 1), current(s.points.size(), 1);
  for (std::size_t v = 0; v < s.points.size(); ++v)
    for (int axis = 0; axis < 3; ++axis) original.row(v, axis)[0] = current.row(v, axis)[0] = float(s.points[v][axis]);
  double height = .1;
  for (int step = 0; step < 60; ++step) {
    for (std::size_t c : corners) current.row(c, 2)[0] = float(height);
    Amf::internal::Pose_quadrics planes(5, 1);
    level.add_planes(
        original, current, 0, [](std::size_t) { return 1.; }, planes);
    double square = 0, linear = 0; // of all corners, which move together
    for (std::size_t k = 0; k < 4; ++k) {
      const Amf::internal::Quadric q = planes.sum(k, 4, 0);
      square += q[5];
      linear += q[8];
    }
    height = -linear / square;
  }
  // of the sheet and the level below, each of area 4, and of the small sheet
  const double below = 8, over = .16 * 4;
  double low = 0, high = above;
  for (int step = 0; step < 50; ++step) {
    const double z = (low + high) / 2, t = above - z, far = 2 * (below * z + over * t) / (below + over);
    (below * z / (z + far) < over * t / (t + far) ? low : high) = z;
  }
  CHECK_NEAR(height, low, .02 * low);
  CHECK(low < .6 * above * over / (below + over));
}

// Places are refined on the way to a level as often as if the stages were levels.
void test_stages()
{
  CHECK((Amf::internal::stages_between(1000, 500) == std::vector<std::size_t>{500}));
  CHECK((Amf::internal::stages_between(1000, 100) == std::vector<std::size_t>{562, 316, 177, 100}));
  CHECK((Amf::internal::stages_between(91, 91) == std::vector<std::size_t>{91}));
  const Shape s = sphere(4);
  const Animation a(s, walking(s.points, 5));
  Amf::Simplification_options o = wanted({100});
  const std::vector<std::size_t> stages = Amf::internal::stages_between(s.points.size(), 100);
  const auto is_same = [&](const Amf::Animation_level& x, const Amf::Animation_level& y) {
    return x.triangles == y.triangles && x.binding.positions(s.points) == y.binding.positions(s.points);
  };
  o.refinements = 1;
  const auto at_once = simplified(a, o);
  o.vertices = stages;
  CHECK(is_same(at_once.levels[0], simplified(a, o).levels.back()));
  o.refinements = 0; // each level begins with all edges, those that were refused, too
  const auto plain = simplified(a, o);
  o.vertices = {100};
  CHECK(is_same(plain.levels.back(), simplified(a, o).levels[0]));
  CHECK(!is_same(plain.levels.back(), at_once.levels[0]));
}

// A surface that crumples: the best places of some edges would turn a triangle over in some frame, and an end or the middle
// of the edge is taken.
void test_crumpled()
{
  Shape s = sphere(3);
  Random random(17);
  for (Vec& p : s.points) p = (p + random.vector(.02)).normalized();
  std::vector<Points> frames(1, s.points);
  for (int f = 0; f < 6; ++f) {
    const Vec wave = random.rotation() * Vec(0, 0, 10);
    frames.push_back(mapped(s.points, [&](const Vec& p) { return Vec((1 + .3 * std::sin(wave.dot(p))) * p); }));
  }
  const Animation a(s, frames);
  Amf::internal::Collapsed_mesh mesh = Amf::internal::mesh_to_collapse(a.sequence);
  const auto index = get(CGAL::vertex_index, mesh);
  Amf::Animation_collapse<Amf::internal::Collapsed_mesh, std::decay_t<decltype(index)>> collapse(
      mesh, index, a.sequence.rest_shape(), a.sequence.trajectories(), wanted({40}));
  const auto cost = collapse.cost();
  const auto placement = collapse.placement();
  const auto filter = collapse.filter();
  std::size_t left = s.points.size(), others = 0;
  const auto counted = [&](const auto& profile, const auto& best) {
    const auto place = filter(profile, best);
    if (place && *place != *best) ++others;
    return place;
  };
  const Amf::Unwatched_simplification watch;
  const Amf::internal::Collapse_counter<Amf::Unwatched_simplification> counter(left, left, 40, watch);
  CGAL::Surface_mesh_simplification::edge_collapse(
      mesh, Amf::internal::Vertex_count_stop(left, 40),
      CGAL::parameters::get_cost(cost).get_placement(placement).filter(counted).visitor(collapse.visitor(counter)));
  CHECK(left < 200 && others > 0);
  const Amf::Animation_level level = Amf::internal::level_of(mesh, collapse);
  for (const auto& e : errors(a, level, true)) CHECK(e.turned <= e.turned_in_original);
  double sum_error = 0;
  for (std::size_t v = 0; v < level.binding.size(); ++v) {
    double sum = 0;
    for (double w : level.binding.weights(v)) sum += w;
    sum_error = (std::max)(sum_error, std::abs(sum - 1));
  }
  CHECK(sum_error < 1e-12);
}

// Far away from the origin single precision has other digits to lose.
void test_moved_far_away()
{
  // irregular, so that no two edges cost the same: roundings would tell which is collapsed
  Shape s = sphere(3);
  Random random(11);
  for (Vec& p : s.points) p = (p + random.vector(.05)).normalized();
  const std::vector<Points> frames = walking(s.points, 4);
  std::vector<Points> far;
  for (const Points& f : frames) far.push_back(mapped(f, [](const Vec& p) { return Vec(p + Vec(1e5, -2e5, 3e5)); }));
  const Animation near_animation(s, frames), far_animation(s, far);
  const auto n = simplified(near_animation, wanted({40})), f = simplified(far_animation, wanted({40}));
  const double e = Amf::worst_frame(errors(near_animation, n.levels[0])).mean();
  CHECK_NEAR(Amf::worst_frame(errors(far_animation, f.levels[0])).mean(), e, .05 * e);
  // nor does the unit matter, as far as single precision goes
  for (double unit : {1e-12, 1e12}) {
    Shape small = s;
    small.points = mapped(s.points, [&](const Vec& p) { return Vec(unit * p); });
    std::vector<Points> scaled;
    for (const Points& p : frames) scaled.push_back(mapped(p, [&](const Vec& q) { return Vec(unit * q); }));
    const Animation a(small, scaled);
    const auto result = simplified(a, wanted({40}));
    const auto worst = Amf::worst_frame(errors(a, result.levels[0]));
    CHECK(result.levels[0].binding.size() == 40 && worst.turned == 0);
    CHECK_NEAR(worst.mean() / unit, e, .05 * e);
  }
}

// The distances of two sheets at a known distance; of one that is turned over.
void test_errors()
{
  const Shape s = sheet(6);
  const Animation a(s, folded(s.points, 3, 0.));
  std::vector<Amf::Rest_shape::Triangle> triangles = a.sequence.rest_shape().triangles();
  const double h = .01;
  const auto lifted = [&](std::size_t f) {
    return mapped(s.points, [&](const Vec& p) { return Vec(p + Vec(0, 0, h * double(f))); });
  };
  Amf::Spatio_temporal_field<float> regions(s.points.size(), 3);
  for (std::size_t v = 0; v < s.points.size(); ++v) regions(v, 2) = s.points[v][0] < 0 ? 1.f : 0.f;
  Amf::Simplification_error_options o;
  o.regions = &regions;
  const auto e =
      Amf::simplification_errors(a.sequence.rest_shape(), a.sequence.trajectories(), triangles, s.points, lifted, o);
  CHECK(e.size() == 3);
  for (std::size_t f = 0; f < 3; ++f) {
    for (double x :
         {e[f].mean_to_coarse, e[f].mean_to_original, e[f].max_to_coarse, e[f].max_to_original, e[f].mean_elsewhere})
      CHECK_NEAR(x, h * double(f), 1e-12);
    CHECK_NEAR(e[f].normal_angle, 0, 1e-5);
    CHECK(e[f].turned == 0);
  }
  CHECK(e[0].share_in_regions == 0 && e[0].mean_in_regions == 0);
  CHECK_NEAR(e[2].mean_in_regions, 2 * h, 1e-12);
  CHECK(e[2].share_in_regions > .35 && e[2].share_in_regions < .55);
  CHECK(Amf::worst_frame(e).frame == 2);
  // one triangle that is turned over; the corners tell, and what is nearest
  std::vector<Amf::Rest_shape::Index> itself(s.points.size());
  std::iota(itself.begin(), itself.end(), Amf::Rest_shape::Index(0));
  Amf::Simplification_error_options by_corners;
  by_corners.vertex_of = &itself;
  const auto measured = [&] {
    return Amf::simplification_errors(a.sequence.rest_shape(), a.sequence.trajectories(), triangles, s.points, lifted,
                                      by_corners);
  };
  CHECK(measured()[1].turned == 0);
  std::swap(triangles[9][1], triangles[9][2]);
  CHECK(measured()[1].turned == 1 && measured()[1].turned_from_nearest == 1 && measured()[1].turned_in_original == 0);
  // corners that stand for all of a closed surface have no side
  const Shape ball = sphere(2);
  const Animation b(ball, walking(ball.points, 3));
  const std::vector<Amf::Rest_shape::Index> all_one(ball.points.size(), 0);
  by_corners.vertex_of = &all_one;
  const auto closed = Amf::simplification_errors(
      b.sequence.rest_shape(), b.sequence.trajectories(), {{{0, 0, 0}}}, {Vec(0, 0, 0)},
      [](std::size_t) { return Points{Vec(0, 0, 0)}; }, by_corners);
  CHECK(closed[0].turned == 0);
  std::swap(triangles[9][1], triangles[9][2]);
  for (auto& t : triangles) std::swap(t[1], t[2]);
  const auto turned =
      Amf::simplification_errors(a.sequence.rest_shape(), a.sequence.trajectories(), triangles, s.points, lifted);
  CHECK(turned[1].turned == triangles.size());
  CHECK_NEAR(turned[1].normal_angle, 180, 1e-5);
}

// Against a search among points of the triangle, and among all triangles.
void test_nearest()
{
  Random random(3);
  double worst = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec a = random.vector(), b = random.vector(), c = k % 10 == 0 ? Vec((a + b) / 2) : random.vector(),
              p = random.vector(2);
    const double d = (p - Amf::internal::nearest_in_triangle(p, a, b, c)).norm();
    double least = 100;
    const int n = 60;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) least = (std::min)(least, (p - (a + (b - a) * i / n + (c - a) * j / n)).norm());
    worst = (std::max)({worst, d - least, least - d - .07});
  }
  CHECK(worst < 1e-9);
  const Shape s = sphere(3);
  const Amf::Rest_shape rest = rest_shape_of(s);
  Amf::internal::Triangle_tree tree(rest.triangles(), rest.points());
  const Points moved = mapped(s.points, [](const Vec& p) { return Vec(2 * p[0], p[1] + p[0] * p[0], -p[2]); });
  tree.follow(moved);
  double difference = 0;
  for (int k = 0; k < 100; ++k) {
    const Vec p = random.vector(2);
    double least = 100;
    for (const auto& t : rest.triangles())
      least = (std::min)(
          least, (p - Amf::internal::nearest_in_triangle(p, moved[t[0]], moved[t[1]], moved[t[2]])).squaredNorm());
    const auto guess = k % 2 == 0 ? Amf::Rest_shape::none : Amf::Rest_shape::Index(k);
    difference = (std::max)(difference, std::abs(tree.nearest(p, guess).square - least));
  }
  CHECK(difference == 0);
}

void test_poses()
{
  const Shape s = sphere(2);
  std::vector<Points> frames(10, s.points);
  Random random(5);
  for (std::size_t f = 0; f < 10; ++f) {
    const double stretch = f == 3 ? 2 : f == 7 ? .5 : 1 + .01 * double(f);
    const Eigen::AngleAxisd turn = random.rotation();
    frames[f] = mapped(
        s.points, [&](const Vec& p) { return Vec(turn * p.cwiseProduct(Vec(stretch, 1, 1)) + Vec(9, 0, double(f))); });
  }
  const Animation a(s, frames);
  const Amf::Rest_shape& rest = a.sequence.rest_shape();
  const auto& t = a.sequence.trajectories();
  CHECK((Amf::choose_poses(rest, t, 2) == std::vector<std::size_t>{3, 7}));
  CHECK((Amf::choose_poses(rest, t, 3, {5, 5, 1}) == std::vector<std::size_t>{5, 1, 3}));
  CHECK(Amf::choose_poses(rest, t, 12).size() == 10);
  CHECK_THROWS(Amf::Option_error, Amf::choose_poses(rest, t, 0), "at least one");
  CHECK_THROWS(Amf::Option_error, Amf::choose_poses(rest, t, 3, {10}), "no frame 10");
  // poses that repeat each other add nothing
  const Animation still(s, std::vector<Points>(6, s.points));
  CHECK(Amf::choose_poses(still.sequence.rest_shape(), still.sequence.trajectories(), 4).size() == 1);
}

void test_guidance()
{
  const Shape s = sphere(4);
  const Animation a(s, walking(s.points, 5));
  std::size_t top = 0;
  for (std::size_t v = 0; v < s.points.size(); ++v)
    if (s.points[v][2] > s.points[top][2]) top = v;
  Amf::Feature_point f;
  f.vertex_index = top;
  f.time = .2;
  f.sigma = .4;
  f.tau = .2;
  f.amplitude = 3;
  const std::vector<Amf::Feature_point> features = {f};
  const auto near_top = [&](double strength) {
    const Amf::Feature_guidance guidance(a.sequence.rest_shape(), 5, .1, features, strength);
    CHECK_NEAR(guidance(top, 2), 1 + strength, 1e-6 * (1 + strength));
    Amf::Simplification_options o = wanted({80});
    o.refinements = 0; // how many there are, not where they go
    const auto result = Amf::simplify_animation(a.sequence, o, guidance);
    std::size_t n = 0;
    for (const Vec& p : result.levels[0].binding.positions(s.points)) n += (p - s.points[top]).norm() < .6 ? 1 : 0;
    return n;
  };
  const std::size_t plain = near_top(0), guided = near_top(30);
  CHECK(plain >= 4);
  CHECK(guided >= 2 * plain);
  // what counts everywhere alike changes nothing
  const auto same = Amf::simplify_animation(a.sequence, wanted({80}), Archetype_guidance(4.));
  CHECK(same.levels[0].triangles == simplified(a, wanted({80})).levels[0].triangles);
  CHECK_THROWS(Amf::Option_error, Amf::Feature_guidance(a.sequence.rest_shape(), 5, .1, features, -1), "negative");
  f.vertex_index = 100000;
  CHECK_THROWS(Amf::Input_error,
               Amf::Feature_guidance(a.sequence.rest_shape(), 5, .1, std::vector<Amf::Feature_point>{f}, 1), "100000");
}

void test_fixed_vertices_and_threads()
{
  const Shape s = sphere(3);
  const Animation a(s, walking(s.points, 4));
  Amf::Simplification_options o = wanted({30});
  o.fixed_vertices = {5, 77, 200};
  const auto result = simplified(a, o);
  for (std::size_t v : o.fixed_vertices) {
    const std::size_t c = result.levels[0].vertex_of[v];
    CHECK(result.levels[0].binding.vertices(c).size() == 1 && result.levels[0].binding.vertices(c)[0] == v);
  }
  CHECK_THROWS(Amf::Option_error, (o.fixed_vertices = {258}, simplified(a, o)), "258");
  o.fixed_vertices.clear();
  const auto usual = simplified(a, o);
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
#endif
  const auto again = simplified(a, o);
  CHECK(usual.levels[0].triangles == again.levels[0].triangles);
  bool is_same = true;
  for (std::size_t v = 0; v < 30; ++v)
    is_same = is_same && usual.levels[0].binding.position(v, s.points) == again.levels[0].binding.position(v, s.points);
  CHECK(is_same);
}

void test_refusals()
{
  Shape s = sphere(2);
  s.add(sheet(4), Vec(0, 0, 3));
  s.points.emplace_back(0, 0, 9); // in no face
  const Animation a(s, walking(s.points, 3));
  const Amf::Simplification_limits limits(a.sequence.rest_shape());
  CHECK(limits.used == 66 + 25 && limits.components == 2 && limits.least == 7);
  CHECK_THROWS(Amf::Option_error, simplified(a, wanted({})), "how many");
  CHECK_THROWS(Amf::Option_error, simplified(a, wanted({92})), "has 91");
  CHECK_THROWS(Amf::Option_error, simplified(a, wanted({50, 50})), "not fewer");
  CHECK_THROWS(Amf::Option_error, simplified(a, wanted({6})), "2 components take 7");
  const auto all = simplified(a, wanted({91}));
  CHECK(all.levels[0].triangles.size() == s.faces.size());
  CHECK(all.levels[0].vertex_of.back() == Amf::Rest_shape::none);
  CHECK(Amf::worst_frame(errors(a, all.levels[0])).hausdorff() < 1e-6);
  for (const auto& change : std::vector<void (*)(Amf::Simplification_options&)>{
           [](auto& o) { o.poses = 0; }, [](auto& o) { o.line_weight = -1; },
           [](auto& o) { o.border_weight = std::nan(""); }, [](auto& o) { o.least_cosine = 1; },
           [](auto& o) { o.support = 0; }}) {
    Amf::Simplification_options o = wanted({40});
    change(o);
    CHECK_THROWS(Amf::Option_error, simplified(a, o), "");
  }
  double told = 0;
  bool grows = true;
  const auto watch = [&](double fraction) {
    grows = grows && fraction >= told && fraction <= 1;
    told = fraction;
    return true;
  };
  Amf::simplify_animation(a.sequence, wanted({20}), Amf::Plain_guidance(), watch);
  CHECK(grows && told == 1);
  CHECK_THROWS(Amf::Cancelled,
               Amf::simplify_animation(a.sequence, wanted({20}), Amf::Plain_guidance(), [](double) { return false; }),
               "");
}

} // namespace

int main()
{
  test_fold();
  test_binding();
  test_topology();
  test_refinement();
  test_pulls();
  test_stages();
  test_crumpled();
  test_moved_far_away();
  test_errors();
  test_nearest();
  test_poses();
  test_guidance();
  test_fixed_vertices_and_threads();
  test_refusals();
  return test_result();
}
