// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CHECK_MANIFOLD_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CHECK_MANIFOLD_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/Numerics/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// The edge from `source` to `target` as a triangle walks along it: its corner number `corner` is at `source`.
struct Directed_edge
{
  std::size_t source, target, triangle;
  int corner;

  std::size_t smaller() const { return (std::min)(source, target); }
  std::size_t larger() const { return (std::max)(source, target); }

  bool operator<(const Directed_edge& other) const
  {
    return std::make_tuple(smaller(), larger(), triangle) <
           std::make_tuple(other.smaller(), other.larger(), other.triangle);
  }
};

constexpr char remedy_for_surface[] = " (the option repair mends it; command line: --repair)";

[[noreturn]] inline void throw_no_surface(const std::string& name, const std::string& message)
{
  throw Input_error(name + ": " + message);
}

// The edges of all triangles, those that belong together one after the other.
inline std::vector<Directed_edge> sorted_edges(const Indexed_mesh& mesh, const std::string& name)
{
  std::vector<Directed_edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<std::size_t, 3>& corners = mesh.triangles[t];
    for (int i = 0; i < 3; ++i) {
      if (corners[i] >= mesh.points.size())
        throw_no_surface(name, "face " + std::to_string(t) + " has a corner at vertex " + std::to_string(corners[i]) +
                                   ", there are " + std::to_string(mesh.points.size()) + " vertices");
      if (corners[i] == corners[(i + 1) % 3])
        throw_no_surface(name, "face " + std::to_string(t) + " has vertex " + std::to_string(corners[i]) + " twice" +
                                   remedy_for_surface);
      edges.push_back({corners[i], corners[(i + 1) % 3], t, i});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Throws unless every edge has one triangle, or two that agree about the outside, and the triangles of every vertex
// hang together by edges.
inline void check_manifold(const Indexed_mesh& mesh, const std::string& name)
{
  const std::vector<Directed_edge> edges = sorted_edges(mesh, name);

  // The sets: corners of triangles that are joined by edges at their vertex.
  const std::size_t corners = 3 * mesh.triangles.size();
  std::vector<std::size_t> rank(corners, 0), parent(corners);
  auto fans = Animated_mesh_features::internal::disjoint_sets(rank.data(), parent.data());
  for (std::size_t i = 0; i < corners; ++i) fans.make_set(i);
  const auto at_source = [](const Directed_edge& e) { return 3 * e.triangle + std::size_t(e.corner); };
  const auto at_target = [](const Directed_edge& e) { return 3 * e.triangle + std::size_t((e.corner + 1) % 3); };

  for (std::size_t i = 0, next; i < edges.size(); i = next) {
    const Directed_edge& e = edges[i];
    next = i + 1;
    while (next < edges.size() && edges[next].smaller() == e.smaller() && edges[next].larger() == e.larger()) ++next;
    if (next - i == 1) continue; // on the border
    const std::string edge = "edge (" + std::to_string(e.smaller()) + ", " + std::to_string(e.larger()) + ")";
    const Directed_edge& other = edges[i + 1];
    if (next - i > 2)
      throw_no_surface(name, edge + " belongs to " + std::to_string(next - i) + " faces, among them " +
                                 std::to_string(e.triangle) + ", " + std::to_string(other.triangle) + " and " +
                                 std::to_string(edges[i + 2].triangle) + "; the mesh must be a manifold" +
                                 remedy_for_surface);
    if (e.source == other.source)
      throw_no_surface(name, "faces " + std::to_string(e.triangle) + " and " + std::to_string(other.triangle) +
                                 " both run along " + edge + " from " + std::to_string(e.source) + " to " +
                                 std::to_string(e.target) + "; the mesh must be oriented consistently" +
                                 remedy_for_surface);
    fans.union_set(at_source(e), at_target(other));
    fans.union_set(at_target(e), at_source(other));
  }

  const std::size_t none = corners;
  std::vector<std::size_t> fan_of_vertex(mesh.points.size(), none);
  for (std::size_t c = 0; c < corners; ++c) {
    const std::size_t v = mesh.triangles[c / 3][c % 3];
    const std::size_t fan = fans.find_set(c);
    if (fan_of_vertex[v] == none) fan_of_vertex[v] = fan;
    if (fan_of_vertex[v] != fan)
      throw_no_surface(name, "vertex " + std::to_string(v) +
                                 " joins parts of the surface that share no edge there, "
                                 "with faces " +
                                 std::to_string(fan_of_vertex[v] / 3) + " and " + std::to_string(c / 3) +
                                 " among them; the mesh must be a manifold" + remedy_for_surface);
  }
}

} // namespace internal

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CHECK_MANIFOLD_H
