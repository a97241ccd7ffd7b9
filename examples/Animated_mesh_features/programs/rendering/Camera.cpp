// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Camera.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Programs::Rendering {

Eigen::Vector3d View_direction::to_camera() const
{
  const double a = azimuth * EIGEN_PI / 180, e = elevation * EIGEN_PI / 180;
  return std::cos(e) * (std::cos(a) * Eigen::Vector3d::Unit((up_axis + 1) % 3) +
                        std::sin(a) * Eigen::Vector3d::Unit((up_axis + 2) % 3)) +
         std::sin(e) * up();
}

Camera fitted_camera(const std::vector<Eigen::Vector3d>& points, const View_direction& direction, double width,
                     double height, double room_width, double room_height, double angle)
{
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.forward = -direction.to_camera();
  camera.right = camera.forward.cross(direction.up()).normalized();
  camera.up = camera.right.cross(camera.forward);
  camera.focal_length = (std::max)(room_width, room_height) / 2 / std::tan(angle / 2 * EIGEN_PI / 180);
  const double slope_x = room_width / 2 / camera.focal_length, slope_y = room_height / 2 / camera.focal_length;

  // A point at (x, y, z) from the origin is inside of a pyramid with its tip at (a, b, -d) if |x - a| <= slope_x (z +
  // d) and |y - b| <= slope_y (z + d): the tightest of these bounds give the tip.
  const double most = (std::numeric_limits<double>::max)();
  double left = -most, right = -most, bottom = -most, top = -most, nearest = most;
  for (const Eigen::Vector3d& p : points) {
    const double x = p.dot(camera.right), y = p.dot(camera.up), z = p.dot(camera.forward);
    right = (std::max)(right, x - slope_x * z);
    left = (std::max)(left, -x - slope_x * z);
    top = (std::max)(top, y - slope_y * z);
    bottom = (std::max)(bottom, -y - slope_y * z);
    nearest = (std::min)(nearest, z);
  }
  const double a = (right - left) / 2, b = (top - bottom) / 2;
  double d = (std::max)((left + right) / (2 * slope_x), (bottom + top) / (2 * slope_y));
  // A single point, or points on the line of sight, would be at the eye.
  if (!(d + nearest > 0)) d = 1 - nearest;
  camera.eye = a * camera.right + b * camera.up - d * camera.forward;
  return camera;
}

} // namespace Programs::Rendering
