// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Geodesic balls: the package's policies against CGAL's heat method as its manual has it, one source after the other on
// the whole mesh or on a patch around each vertex, and against fast marching; time, and error against exact geodesics.

#include "Fast_marching.h"
#include "animations.h"
#include "benchmark_support.h"

#include <CGAL/Animated_mesh_features/Geodesic_balls/CGAL_heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Dijkstra_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Heat_method_geodesic_balls.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

using namespace Benchmark;

namespace {

typedef Amf::Rest_shape Rest_shape;
typedef Rest_shape::Index Index;

const double edges_in_radius = 3;

// The part of a shape that reaches `radius` along its edges from a vertex, as a mesh of its own.
template <class Kernel>
struct Patch
{
  typedef CGAL::Surface_mesh<typename Kernel::Point_3> Mesh;
  typedef typename Mesh::Vertex_index Vertex;

  Mesh mesh;
  std::vector<Index> vertices; // of the shape
  Vertex source;

  Patch(const Rest_shape& shape, Index centre, double radius)
  {
    std::unordered_map<Index, double> distances;
    std::vector<std::pair<double, Index>> queue = {{0, centre}};
    distances[centre] = 0;
    std::vector<Index> triangles;
    while (!queue.empty()) {
      std::pop_heap(queue.begin(), queue.end(), std::greater<>());
      const auto [d, v] = queue.back();
      queue.pop_back();
      if (d > distances[v]) continue;
      triangles.insert(triangles.end(), shape.incident_triangles()[v].begin(), shape.incident_triangles()[v].end());
      for (Index w : shape.neighbours()[v]) {
        const double e = d + (shape.points()[v] - shape.points()[w]).norm();
        const auto known = distances.find(w);
        if (e > radius || (known != distances.end() && known->second <= e)) continue;
        distances[w] = e;
        queue.emplace_back(e, w);
        std::push_heap(queue.begin(), queue.end(), std::greater<>());
      }
    }
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    std::unordered_map<Index, Vertex> numbers;
    const auto number = [&](Index v) {
      const auto inserted = numbers.emplace(v, Vertex());
      if (inserted.second) {
        const Rest_shape::Point& p = shape.points()[v];
        inserted.first->second = mesh.add_vertex(typename Kernel::Point_3(p[0], p[1], p[2]));
        vertices.push_back(v);
      }
      return inserted.first->second;
    };
    for (Index t : triangles)
      if (shape.areas()[t] > 0) {
        const Rest_shape::Triangle& c = shape.triangles()[t];
        mesh.add_face(number(c[0]), number(c[1]), number(c[2]));
      }
    source = number(centre);
  }
};

// CGAL's class as its manual has it, for one source after the other. The extrinsic Laplacian, which is quicker than the
// default, and what the package uses.
template <class Mesh>
class Heat_method
{
public:
  explicit Heat_method(const Mesh& mesh)
    : m_distances(num_vertices(mesh))
    , m_method(mesh)
  {}

  const std::vector<double>& operator()(typename Mesh::Vertex_index source)
  {
    m_method.clear_sources();
    m_method.add_source(source);
    m_method.estimate_geodesic_distances(
        boost::make_iterator_property_map(m_distances.begin(), boost::typed_identity_property_map<std::size_t>()));
    return m_distances;
  }

private:
  std::vector<double> m_distances;
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, CGAL::Heat_method_3::Direct> m_method;
};

// Distances from a source; what is not in it is too far.
typedef std::unordered_map<Index, double> Distances;

Distances heat_method_on_patch(const Rest_shape& shape, Index source, double radius)
{
  typedef Patch<Animation::Kernel> Heat_patch;
  const Heat_patch patch(shape, source, 2 * radius);
  Heat_method<Heat_patch::Mesh> method(patch.mesh);
  const std::vector<double>& d = method(patch.source);
  Distances result;
  for (std::size_t i = 0; i < d.size(); ++i) result[patch.vertices[i]] = d[i];
  return result;
}

Distances exact_distances(const Rest_shape& shape, Index source, double radius)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Patch<Kernel> Exact_patch;
  typedef CGAL::Surface_mesh_shortest_path_traits<Kernel, Exact_patch::Mesh> Traits;
  const Exact_patch patch(shape, source, 2 * radius);
  CGAL::Surface_mesh_shortest_path<Traits> shortest_paths(patch.mesh);
  shortest_paths.add_source_point(patch.source);
  Distances result;
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    const double d = double(
        shortest_paths.shortest_distance_to_source_points(Exact_patch::Vertex(typename Exact_patch::Mesh::size_type(i)))
            .first);
    if (d >= 0) result[patch.vertices[i]] = d;
  }
  return result;
}

std::vector<Index> sample(const Rest_shape& shape, std::size_t size)
{
  std::vector<Index> result;
  const std::size_t n = shape.number_of_vertices();
  for (std::size_t i = 0; i < (std::min)(size, n); ++i) result.push_back(Index(i * n / (std::min)(size, n)));
  return result;
}

// ------------------------------------------------------------------------------------------------------------- errors

struct Errors
{
  double distances = 0, edges = 0;
};

class Error_measure
{
public:
  Error_measure(const Rest_shape& shape, double radius, const std::vector<Index>& sources)
    : m_shape(shape)
    , m_radius(radius)
    , m_sources(sources)
  {
    for (Index s : sources) m_exact.push_back(exact_distances(shape, s, radius));
  }

  // `distances(source)` are those of a method.
  template <class Function>
  Errors operator()(const Function& distances) const
  {
    double sum = 0;
    std::size_t count = 0, common = 0, all = 0;
    for (std::size_t i = 0; i < m_sources.size(); ++i) {
      const Distances d = distances(m_sources[i]);
      const auto distance = [&](const Distances& from, Index v) {
        const auto found = from.find(v);
        return found == from.end() ? std::numeric_limits<double>::infinity() : found->second;
      };
      for (const auto& exact : m_exact[i])
        if (exact.second >= m_radius / 2 && exact.second <= m_radius) {
          // what is not found within twice the radius is as wrong as that
          sum += std::abs((std::min)(distance(d, exact.first), 2 * m_radius) - exact.second) / exact.second;
          ++count;
        }
      for (const auto& exact : m_exact[i])
        for (Index w : m_shape.neighbours()[exact.first]) {
          if (w < exact.first) continue; // each edge once
          const auto is_in = [&](const Distances& from) {
            return distance(from, exact.first) <= m_radius && distance(from, w) <= m_radius;
          };
          const bool a = is_in(m_exact[i]), b = is_in(d);
          common += a && b;
          all += a || b;
        }
    }
    return {sum / double(count), double(common) / double(all)};
  }

private:
  const Rest_shape& m_shape;
  double m_radius;
  std::vector<Index> m_sources;
  std::vector<Distances> m_exact;
};

// A policy tells balls, not distances: the distance of a vertex is the radius from which on it is in the ball, found in
// steps of 1/50 of the radius of interest, one of whose ends that is.
template <class Policy>
std::map<Index, Distances> distances_by_radii(const Rest_shape& shape, double radius, const std::vector<Index>& sources,
                                              const Policy& policy)
{
  std::map<Index, Distances> result;
  const double step = radius / 50;
  for (int i = 15; i <= 70; ++i) {
    const Amf::Compressed_rows balls = policy(shape, i * step, Policy_loop());
    for (Index s : sources)
      for (Index v : balls[s]) result[s].emplace(v, (i - 0.5) * step); // only if it was not in a smaller ball
  }
  return result;
}

void compare_errors(const std::string& name, const Mesh& mesh, const Arguments& arguments, Report& report)
{
  const Rest_shape shape = rest_shape(mesh);
  const double radius = edges_in_radius * shape.mean_edge_length();
  const std::vector<Index> sources = sample(shape, arguments.quick ? 10 : 200);
  const Error_measure errors(shape, radius, sources);
  Table table(
      "Errors of geodesic balls: " + name,
      "N = " + std::to_string(shape.number_of_vertices()) + ", radius 3 mean edge lengths, " +
          std::to_string(sources.size()) +
          " sources. Reference: CGAL::Surface_mesh_shortest_path. Error of the "
          "distance: mean over vertices between half of the radius and the radius. Edges in common: those with "
          "both ends in the ball, intersection over union. The distances of policies follow from their balls of "
          "56 radii, and are known to 1 % of the radius.",
      {"method", "error of the distance %", "edges in common"});
  const auto add = [&](const char* method, const Errors& e) { table.add(method, 100 * e.distances, e.edges); };
  const auto add_policy = [&](const char* method, const auto& policy) {
    const std::map<Index, Distances> d = distances_by_radii(shape, radius, sources, policy);
    add(method, errors([&](Index s) { return d.at(s); }));
  };
  {
    Heat_method<Mesh> whole(mesh);
    add("CGAL heat method, whole mesh", errors([&](Index s) {
          const std::vector<double>& d = whole(Mesh::Vertex_index(s));
          Distances result;
          for (std::size_t v = 0; v < d.size(); ++v) result[Index(v)] = d[v];
          return result;
        }));
  }
  add("CGAL heat method, patch of each vertex",
      errors([&](Index s) { return heat_method_on_patch(shape, s, radius); }));
  add_policy("CGAL_heat_method_geodesic_balls", Amf::CGAL_heat_method_geodesic_balls());
  add_policy("Heat_method_geodesic_balls (default)", Amf::Heat_method_geodesic_balls());
  add_policy("Dijkstra_geodesic_balls", Amf::Dijkstra_geodesic_balls());
  Fast_marching marching(shape);
  add("fast marching, unfolded", errors([&](Index s) {
        Distances result;
        for (Index v : marching.run(s, 2 * radius)) result[v] = marching.distance(v);
        return result;
      }));
  report.add(table);
}

// --------------------------------------------------------------------------------------------------------------- time

void compare_times(const Mesh& mesh, const Arguments& arguments, Table& table)
{
  const Rest_shape shape = rest_shape(mesh);
  const std::size_t n = shape.number_of_vertices();
  const double radius = edges_in_radius * shape.mean_edge_length();
  const Repetitions repeated = arguments.quick ? Repetitions{1, 1, 0} : Repetitions{1, 5, 2};
  const auto policy_seconds = [&](const auto& policy, std::size_t threads) {
    const Thread_limit limit(threads);
    return least_seconds([&] { policy(shape, radius, Policy_loop()); }, repeated);
  };
  const double clusters = policy_seconds(Amf::Heat_method_geodesic_balls(), 1);
  const auto add = [&](const char* method, std::size_t threads, double seconds, const std::string& measured) {
    table.add(n, method, threads, seconds, 1e6 * seconds / double(n), seconds / clusters, measured);
  };
  {
    const std::size_t sources = arguments.quick ? 2 : 20;
    std::unique_ptr<Heat_method<Mesh>> whole;
    const double factorization = seconds_of([&] { whole = std::make_unique<Heat_method<Mesh>>(mesh); });
    double least = std::numeric_limits<double>::infinity();
    for (Index s : sample(shape, sources))
      least = (std::min)(least, seconds_of([&] { (*whole)(Mesh::Vertex_index(s)); }));
    add("CGAL heat method, whole mesh", 1, factorization + double(n) * least,
        "factorisation " + shown(factorization) + " s, least of " + std::to_string(sources) + " solves " +
            shown(1e3 * least) + " ms, times N");
  }
  {
    const std::vector<Index> sources = sample(shape, arguments.quick ? 20 : 500);
    const double seconds = least_seconds(
        [&] {
          for (Index s : sources) heat_method_on_patch(shape, s, radius);
        },
        repeated);
    add("CGAL heat method, patch of each vertex", 1, seconds / double(sources.size()) * double(n),
        std::to_string(sources.size()) + " sources, extrapolated");
  }
  {
    const std::vector<Index> sources = sample(shape, arguments.quick ? 500 : 20000);
    std::unique_ptr<Fast_marching> marching;
    const double preparation = seconds_of([&] { marching = std::make_unique<Fast_marching>(shape); });
    const double seconds = least_seconds(
        [&] {
          for (Index s : sources) marching->run(s, radius);
        },
        repeated);
    add("fast marching, unfolded", 1, preparation + seconds / double(sources.size()) * double(n),
        "unfolding " + shown(preparation) + " s, " + std::to_string(sources.size()) + " sources, extrapolated");
  }
  if (n < 50000)
    add("CGAL_heat_method_geodesic_balls", 1, policy_seconds(Amf::CGAL_heat_method_geodesic_balls(), 1), "all");
  add("Heat_method_geodesic_balls (default)", 1, clusters, "all");
  add("Dijkstra_geodesic_balls", 1, policy_seconds(Amf::Dijkstra_geodesic_balls(), 1), "all");
  for (std::size_t threads : thread_counts())
    if (threads > 1) {
      add("Heat_method_geodesic_balls (default)", threads, policy_seconds(Amf::Heat_method_geodesic_balls(), threads),
          "all");
      add("Dijkstra_geodesic_balls", threads, policy_seconds(Amf::Dijkstra_geodesic_balls(), threads), "all");
    }
}

Mesh figure_mesh(std::size_t vertices)
{
  return figure(vertices, 1).animation.mesh;
}

} // namespace

int main(int argc, char* argv[])
{
  return run("balls", argc, argv, [](const Arguments& arguments, Report& report) {
    const Mesh small = figure_mesh(arguments.quick ? 1200 : 5000);
    compare_errors("figure", small, arguments, report);
    if (has_horse(arguments) && !arguments.quick) {
      const Workload w = horse(arguments);
      Mesh standing = w.animation.mesh;
      for (const auto v : vertices(standing)) standing.point(v) = w.rest[v];
      compare_errors("standing horse", standing, arguments, report);
    }
    Table table("Geodesic balls of all vertices",
                "Figure, for more than 5,000 vertices with its edges split in the middle; radius 3 mean edge lengths.",
                {"N", "method", "threads", "s", "us a vertex", "this / default", "measured"});
    compare_times(small, arguments, table);
    if (!arguments.quick) {
      compare_times(subdivided(figure_mesh(10000)), arguments, table);
      const Mesh large = subdivided(figure_mesh(25000));
      compare_times(large, arguments, table);
      compare_times(subdivided(large), arguments, table);
    }
    report.add(table);
  });
}
