// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_CAMERA_H
#define PROGRAMS_RENDERING_CAMERA_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace Rendering {

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

A perspective camera. Pixels are counted from the top left corner of the image; the centre of the first one is at
(0.5, 0.5).
*/
struct Camera
{
  typedef Eigen::Vector3d Vector; ///< a position or a direction

  Vector eye = Vector::Zero();       ///< where it is.
  Vector right = Vector::UnitX();    ///< to the right of the image; unit vector.
  Vector up = Vector::UnitY();       ///< to the top of the image; unit vector.
  Vector forward = -Vector::UnitZ(); ///< along the line of sight; unit vector, orthogonal to the other two.

  /// pixels: what is as far to the right as it is far away lies there, from the centre.
  double focal_length = 1;
  double width = 1;  ///< of the image, pixels.
  double height = 1; ///< of the image, pixels.

  /// the pixel coordinates of a point, and its distance along the view direction, positive in front of the camera.
  Vector project(const Vector& p) const
  {
    const Vector d = p - eye;
    const double z = d.dot(forward);
    return Vector(width / 2 + focal_length * d.dot(right) / z, height / 2 - focal_length * d.dot(up) / z, z);
  }

  /// the vector from the eye to the point at distance 1 along the view direction that is seen at a place of the image.
  Vector ray(double x, double y) const
  {
    return forward + ((x - width / 2) * right + (height / 2 - y) * up) / focal_length;
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

where a camera looks from: the angles under which the body sees it.
*/
struct View_direction
{
  int up_axis = 1;      ///< 0, 1 or 2: x, y or z points up.
  double azimuth = 0;   ///< degrees, around the up axis, counterclockwise seen from above.
  double elevation = 0; ///< degrees above the horizon, less than 90.

  /// the unit vector that points up.
  Eigen::Vector3d up() const { return Eigen::Vector3d::Unit(up_axis); }

  /// from the body to the camera, a unit vector; azimuth 0 is along z if y points up, along x if z does, along y if x
  /// does.
  Eigen::Vector3d to_camera() const
  {
    const double a = azimuth * EIGEN_PI / 180, e = elevation * EIGEN_PI / 180;
    return std::cos(e) * (std::cos(a) * Eigen::Vector3d::Unit((up_axis + 1) % 3) +
                          std::sin(a) * Eigen::Vector3d::Unit((up_axis + 2) % 3)) +
           std::sin(e) * up();
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

the camera that sees all of the points as large as possible in a rectangle around the middle of the image.

\param points at least one
\param direction where it looks from
\param width,height the image, pixels
\param room_width,room_height the rectangle for the points, pixels
\param angle the opening of the rectangle's longer side (degrees): 24 by default, as portraits are taken
*/
inline Camera fitted_camera(const std::vector<Eigen::Vector3d>& points, const View_direction& direction, double width,
                            double height, double room_width, double room_height, double angle = 24)
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

} // namespace Rendering
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_RENDERING_CAMERA_H
