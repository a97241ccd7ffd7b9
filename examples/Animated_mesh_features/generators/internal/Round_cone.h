// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_INTERNAL_ROUND_CONE_H
#define ANIMATED_MESH_GENERATORS_INTERNAL_ROUND_CONE_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace Animated_mesh_generators {
namespace internal {

/// The convex hull of two balls, that is, a bone with flesh around it.
struct Round_cone
{
  Eigen::Vector3d from, to;
  double from_radius, to_radius;

  /// the signed distance (negative inside) of a point to the surface, exact as long as neither ball holds the other.
  ///
  /// In the plane through the point and the axis, with coordinates (along the axis, away from it), the surface is two
  /// circles and the line that touches both; the line's normal leans by the sine `(from_radius - to_radius) / length`
  /// along the axis. The point's foot along that normal tells which of the three is nearest.
  double distance(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector3d axis = to - from, d = p - from;
    const double length = axis.norm();
    const double lean = (from_radius - to_radius) / length;
    const double along = d.dot(axis) / length;
    const double away = std::sqrt((std::max)(0., d.squaredNorm() - along * along));
    const double cosine = std::sqrt((std::max)(0., 1 - lean * lean));
    const double foot = along - away * lean / cosine;
    if (foot <= 0) return d.norm() - from_radius;
    if (foot >= length) return (p - to).norm() - to_radius;
    return along * lean + away * cosine - from_radius;
  }
};

/// The minimum of two distances, blended where they differ by less than `width`; twice continuously differentiable. It
/// is at most `width / 6` below the minimum, where both are equal.
inline double smooth_minimum(double a, double b, double width)
{
  const double h = (std::max)(0., width - std::abs(a - b)) / width;
  return (std::min)(a, b) - h * h * h * width / 6;
}

} // namespace internal
} // namespace Animated_mesh_generators

#endif // ANIMATED_MESH_GENERATORS_INTERNAL_ROUND_CONE_H
