// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VIEW_ANGLES_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VIEW_ANGLES_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesViews

Where an upright camera looks from, as a person says it.
*/
struct View_angles
{
  double azimuth = 0;   ///< degrees around the up direction, counterclockwise seen from above, above -180 up to 180
  double elevation = 0; ///< degrees above the horizon, -90 to 90
};

namespace internal {

// The horizontal axis of azimuth 0: the coordinate axis after the one that points up most - z if that is y, x if it is z,
// y if it is x -, or what of it is orthogonal to a direction that is no axis.
inline Eigen::Vector3d azimuth_origin(const Eigen::Vector3d& up)
{
  int axis = 0;
  up.cwiseAbs().maxCoeff(&axis);
  const Eigen::Vector3d next = Eigen::Vector3d::Unit((axis + 1) % 3);
  return (next - next.dot(up) * up).normalized();
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesViews

the angles of a direction.
\param direction from the body to the camera, a unit vector; vertical ones have azimuth 0.
\param up the direction that points up, a unit vector. Azimuth 0 is along `+z` if `y` points up, along `+x` if `z` does,
  along `+y` if `x` does.
*/
inline View_angles view_angles(const Eigen::Vector3d& direction, const Eigen::Vector3d& up)
{
  const Eigen::Vector3d front = internal::azimuth_origin(up), side = up.cross(front);
  const double degree = double(EIGEN_PI) / 180, x = direction.dot(front), y = direction.dot(side),
               z = direction.dot(up);
  View_angles result;
  result.elevation = std::atan2(z, std::hypot(x, y)) / degree;
  if (std::hypot(x, y) > 1e-12) result.azimuth = std::atan2(y, x) / degree;
  if (!(result.azimuth > -180)) result.azimuth = 180; // of a negative zero
  return result;
}

/*!
\ingroup PkgAnimatedMeshFeaturesViews

the direction from the body to the camera, a unit vector, under angles; the inverse of `view_angles()`.
*/
inline Eigen::Vector3d view_direction(const View_angles& angles, const Eigen::Vector3d& up)
{
  const Eigen::Vector3d front = internal::azimuth_origin(up), side = up.cross(front);
  const double a = angles.azimuth * double(EIGEN_PI) / 180, e = angles.elevation * double(EIGEN_PI) / 180;
  return std::cos(e) * (std::cos(a) * front + std::sin(a) * side) + std::sin(e) * up;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VIEW_ANGLES_H
