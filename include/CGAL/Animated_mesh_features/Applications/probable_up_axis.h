// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_PROBABLE_UP_AXIS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_PROBABLE_UP_AXIS_H

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// How well a body stands if this axis points up: how far inside of the bounding rectangle of its lowest points its
// centre is, as a fraction of its half width; 1 for a box, negative for what topples.
inline double stability(const std::vector<Eigen::Vector3d>& points, int axis)
{
  const double lowest_part = 0.06; // of the height: feet
  const double most = (std::numeric_limits<double>::max)();
  Eigen::Vector3d low = Eigen::Vector3d::Constant(most), high = -low, mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p), mean += p;
  mean /= double(points.size());
  const double level = low[axis] + lowest_part * (high[axis] - low[axis]);
  Eigen::Vector3d foot_low = Eigen::Vector3d::Constant(most), foot_high = -foot_low;
  for (const Eigen::Vector3d& p : points)
    if (p[axis] <= level) foot_low = foot_low.cwiseMin(p), foot_high = foot_high.cwiseMax(p);
  double result = 1;
  for (int i : {(axis + 1) % 3, (axis + 2) % 3}) {
    const double half_width = (high[i] - low[i]) / 2;
    if (!(half_width > 0)) continue;
    result = (std::min)(result, (std::min)(mean[i] - foot_low[i], foot_high[i] - mean[i]) / half_width);
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesViews

the axis that probably points up, `y` (1) or `z` (2): the one on which the body stands more stably, and `y` if there is no
clear difference. Files do not tell; animals and people at rest are told well, what does not stand is not.
\param points at least one: the body at rest.
*/
inline int probable_up_axis(const std::vector<Eigen::Vector3d>& points)
{
  const double clear_difference = 0.05;
  return internal::stability(points, 2) > internal::stability(points, 1) + clear_difference ? 2 : 1;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_PROBABLE_UP_AXIS_H
