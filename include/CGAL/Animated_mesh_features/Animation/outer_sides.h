// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_OUTER_SIDES_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_OUTER_SIDES_H

#include <CGAL/Animated_mesh_features/Numerics/Disjoint_sets.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// A connected part of a surface.
struct Surface_part
{
  double border = 0, volume = 0; // length; times 6
  Eigen::Vector3d low = Eigen::Vector3d::Constant((std::numeric_limits<double>::max)()), high = -low;

  std::int8_t outer_side() const
  {
    const double most = 0.1; // of the diagonal of its bounding box
    if (border > most * (high - low).norm()) return 0;
    return volume > 0 ? 1 : volume < 0 ? -1 : 0;
  }
};

// The edges that one triangle has, their ends in the upper and the lower half of a number.
template <class TriangleRange>
std::vector<std::uint64_t> border_edges(const TriangleRange& triangles)
{
  std::vector<std::uint64_t> edges, border;
  edges.reserve(3 * triangles.size());
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto ends = std::minmax(t[i], t[(i + 1) % 3]);
      edges.push_back(std::uint64_t(ends.first) << 32 | ends.second);
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i)
    if ((i == 0 || edges[i - 1] != edges[i]) && (i + 1 == edges.size() || edges[i + 1] != edges[i]))
      border.push_back(edges[i]);
  return border;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

tells for each triangle which of its sides is outside, so that what faces away from a camera or a light need not be drawn to
find out what it hides.

A connected part of the surface is closed if its borders together are no longer than a tenth of the diagonal of its bounding
box, as around eyes: hardly any light gets through. Which side is which tells the sign of its volume.

\param points the `N` positions.
\param triangles a random access range of `M` triples of vertex numbers below \f$2^{32}\f$; triangles agree with their neighbours
  on which side is which.
\returns 1 for the side from which the corners are counterclockwise, -1 for the other one; 0 where there is no outside, since
  the part that the triangle belongs to is open. \f$O(N + M \log M)\f$ time.
*/
template <class TriangleRange>
std::vector<std::int8_t> outer_sides(const std::vector<Eigen::Vector3d>& points, const TriangleRange& triangles)
{
  std::vector<std::size_t> rank(points.size(), 0), parent(points.size());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  internal::Disjoint_sets sets = internal::disjoint_sets(rank.data(), parent.data());
  for (const auto& t : triangles) {
    sets.union_set(std::size_t(t[0]), std::size_t(t[1]));
    sets.union_set(std::size_t(t[1]), std::size_t(t[2]));
  }
  std::vector<internal::Surface_part> parts(points.size()); // by their roots
  for (std::size_t v = 0; v < points.size(); ++v) {
    internal::Surface_part& part = parts[sets.find_set(v)];
    part.low = part.low.cwiseMin(points[v]);
    part.high = part.high.cwiseMax(points[v]);
  }
  for (const auto& t : triangles) {
    internal::Surface_part& part = parts[sets.find_set(std::size_t(t[0]))];
    const Eigen::Vector3d middle = (part.low + part.high) / 2; // for what is nearly closed
    part.volume += (points[t[0]] - middle).dot((points[t[1]] - middle).cross(points[t[2]] - middle));
  }
  for (const std::uint64_t e : internal::border_edges(triangles)) {
    const std::size_t a = std::size_t(e >> 32), b = std::size_t(e & 0xffffffffu);
    parts[sets.find_set(a)].border += (points[a] - points[b]).norm();
  }
  std::vector<std::int8_t> sides;
  sides.reserve(triangles.size());
  for (const auto& t : triangles) sides.push_back(parts[sets.find_set(std::size_t(t[0]))].outer_side());
  return sides;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_OUTER_SIDES_H
