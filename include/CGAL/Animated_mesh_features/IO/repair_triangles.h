// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_REPAIR_TRIANGLES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_REPAIR_TRIANGLES_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/internal/Edge_groups.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

What `repair_triangles()` makes of a file's triangles.
*/
struct Repaired_triangles
{
  /// those of the file in their order, but for those left out.
  std::vector<std::array<std::size_t, 3>> triangles;

  std::size_t collapsed = 0;       ///< that had a vertex twice; left out
  std::size_t repeated = 0;        ///< that had the vertices of one before; left out
  std::size_t turned_round = 0;    ///< that had another orientation than most of their component
  std::size_t branching_edges = 0; ///< of three triangles or more; nothing is oriented across them
};

namespace internal {

typedef std::vector<std::array<std::size_t, 3>> Triangle_list;

// Without triangles that say nothing about the surface.
inline Repaired_triangles distinct_triangles(const Triangle_list& triangles)
{
  Repaired_triangles result;
  std::unordered_set<std::array<std::size_t, 3>, boost::hash<std::array<std::size_t, 3>>> known;
  known.reserve(triangles.size());
  for (const std::array<std::size_t, 3>& t : triangles) {
    std::array<std::size_t, 3> corners = t;
    std::sort(corners.begin(), corners.end());
    if (corners[0] == corners[1] || corners[1] == corners[2])
      ++result.collapsed;
    else if (!known.insert(corners).second)
      ++result.repeated;
    else
      result.triangles.push_back(t);
  }
  return result;
}

// The corner at which the other triangle of an edge has that edge, or none: on borders, and where more than two meet.
inline std::vector<std::size_t> opposite_corners(Repaired_triangles& r, std::size_t number_of_vertices)
{
  const std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> opposite(3 * r.triangles.size(), none);
  const auto vertex = [&](std::size_t c) { return r.triangles[c / 3][c % 3]; };
  for_each_edge(opposite.size(), number_of_vertices, vertex, [&](const std::size_t* first, const std::size_t* last) {
    if (last - first > 2) ++r.branching_edges;
    if (last - first != 2) return;
    opposite[first[0]] = first[1];
    opposite[first[1]] = first[0];
  });
  return opposite;
}

// Orients each component like most of its triangles, if half of them each like its first.
class Orientation
{
public:
  Orientation(Repaired_triangles& r, const std::vector<std::size_t>& opposite, const std::string& file)
    : m_repaired(r)
    , m_opposite(opposite)
    , m_file(file)
    , m_side(r.triangles.size(), 0)
  {}

  void operator()()
  {
    for (std::size_t t = 0; t < m_side.size(); ++t) {
      if (m_side[t] != 0) continue;
      const std::vector<std::size_t> component = sides_from(t);
      const auto like_first =
          std::count_if(component.begin(), component.end(), [&](std::size_t u) { return m_side[u] == 1; });
      const signed char wrong = 2 * std::size_t(like_first) < component.size() ? 1 : -1;
      for (std::size_t u : component) {
        if (m_side[u] != wrong) continue;
        std::swap(m_repaired.triangles[u][1], m_repaired.triangles[u][2]);
        ++m_repaired.turned_round;
      }
    }
  }

private:
  // Gives a side, 1 or -1, to all triangles of a component, and returns them.
  std::vector<std::size_t> sides_from(std::size_t first)
  {
    std::vector<std::size_t> component(1, first);
    m_side[first] = 1;
    for (std::size_t i = 0; i < component.size(); ++i)
      for (std::size_t c = 3 * component[i]; c < 3 * component[i] + 3; ++c) {
        if (m_opposite[c] == (std::numeric_limits<std::size_t>::max)()) continue;
        const std::size_t other = m_opposite[c] / 3;
        const bool agree = vertex(c) != vertex(m_opposite[c]); // they walk along the edge in opposite directions
        const auto side = static_cast<signed char>(agree ? m_side[c / 3] : -m_side[c / 3]);
        if (m_side[other] == 0) {
          m_side[other] = side;
          component.push_back(other);
        } else if (m_side[other] != side) {
          throw Input_error(m_file +
                            ": the surface has one side only, like a Moebius strip: it cannot be oriented, at " +
                            "the edge of vertices " + std::to_string(vertex(c)) + " and " +
                            std::to_string(vertex(c % 3 == 2 ? c - 2 : c + 1)));
        }
      }
    return component;
  }

  std::size_t vertex(std::size_t corner) const { return m_repaired.triangles[corner / 3][corner % 3]; }

  Repaired_triangles& m_repaired;
  const std::vector<std::size_t>& m_opposite;
  const std::string& m_file;
  std::vector<signed char> m_side; // of each triangle; 0: not known yet
};

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

mends the triangles of a file as far as vertices stay what they are: leaves out those that have a vertex twice, or the
vertices of one before them, and turns round what is oriented unlike most of its component. What is left to do to make
a manifold of them, to split vertices and edges at which more of the surface meets than fits, is that of `weld_surface()`.

Expected linear time, but for sorting vertices' own edges.

\param triangles corners are less than `number_of_vertices`
\param number_of_vertices that of the file
\param file its name, for messages
\throws Input_error if a component cannot be oriented.
*/
inline Repaired_triangles repair_triangles(const std::vector<std::array<std::size_t, 3>>& triangles,
                                           std::size_t number_of_vertices, const std::string& file)
{
  Repaired_triangles result = internal::distinct_triangles(triangles);
  const std::vector<std::size_t> opposite = internal::opposite_corners(result, number_of_vertices);
  internal::Orientation(result, opposite, file)();
  return result;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_REPAIR_TRIANGLES_H
