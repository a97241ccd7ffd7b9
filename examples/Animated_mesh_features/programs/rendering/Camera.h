// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_CAMERA_H
#define PROGRAMS_RENDERING_CAMERA_H

#include <Eigen/Core>

#include <vector>

namespace Programs::Rendering {

// A perspective camera. Pixels are counted from the top left corner of the image; the centre of the first one is at
// (0.5, 0.5).
struct Camera
{
  typedef Eigen::Vector3d Vector; // a position or a direction

  Vector eye = Vector::Zero();
  Vector right = Vector::UnitX();    // to the right of the image; unit vector
  Vector up = Vector::UnitY();       // to the top of the image; unit vector
  Vector forward = -Vector::UnitZ(); // along the line of sight; unit vector, orthogonal to the other two

  // pixels: what is as far to the right as it is far away lies there, from the centre
  double focal_length = 1;
  double width = 1, height = 1; // of the image, pixels

  // the pixel coordinates of a point, and its distance along the view direction, positive in front of the camera
  Vector project(const Vector& p) const
  {
    const Vector d = p - eye;
    const double z = d.dot(forward);
    return Vector(width / 2 + focal_length * d.dot(right) / z, height / 2 - focal_length * d.dot(up) / z, z);
  }

  // the vector from the eye to the point at distance 1 along the view direction that is seen at a place of the image
  Vector ray(double x, double y) const
  {
    return forward + ((x - width / 2) * right + (height / 2 - y) * up) / focal_length;
  }
};

// Where a camera looks from: the angles under which the body sees it.
struct View_direction
{
  int up_axis = 1;      // 0, 1 or 2: x, y or z points up
  double azimuth = 0;   // degrees, around the up axis, counterclockwise seen from above
  double elevation = 0; // degrees above the horizon, less than 90

  // the unit vector that points up
  Eigen::Vector3d up() const { return Eigen::Vector3d::Unit(up_axis); }

  // From the body to the camera, a unit vector; azimuth 0 is along z if y points up, along x if z does, along y if x
  // does.
  Eigen::Vector3d to_camera() const;
};

// The camera that sees all of the points, at least one, as large as possible in a rectangle around the middle of the
// image: `room_width` by `room_height` of `width` by `height` pixels. `angle` (degrees) is the opening of the
// rectangle's longer side: 24 by default, as portraits are taken.
Camera fitted_camera(const std::vector<Eigen::Vector3d>& points, const View_direction& direction, double width,
                     double height, double room_width, double room_height, double angle = 24);

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_CAMERA_H
