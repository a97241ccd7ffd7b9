// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_SPHERES_H
#define PROGRAMS_RENDERING_SPHERES_H

#include "rendering/Camera.h"
#include "rendering/Colour.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace Programs::Rendering {

// A sphere of coloured glass.
struct Sphere
{
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;
  Colour colour = Colour::Zero(); // of what it lets through
  float opacity = 1;              // 0: not to be seen
  float filling = 1;              // of its inside, compared with its outline
  bool is_dashed = false;         // its outline
  std::size_t rank = 0;           // the number to be written on it, from 1; 0: none
};

// Draws translucent spheres over what a camera sees. Their outlines are dark, and where a sphere meets the surface there
// is a dark line: so their places and sizes can be read also without colours.
class Sphere_painter
{
public:
  // Spheres in any order, the camera of the picture, the direction of the highlights (unit vector), and the width of the
  // dark lines (pixels).
  Sphere_painter(std::vector<Sphere> spheres, const Camera& camera, const Eigen::Vector3d& to_light, double line_width);

  // the ranks of the spheres that may be seen in a row of pixels
  std::vector<std::size_t> in_row(std::size_t y) const;

  // whether a sphere may be seen in a column of pixels
  bool is_near(std::size_t sphere, std::size_t x) const
  {
    return m_boxes[sphere][0] <= double(x + 1) && double(x) <= m_boxes[sphere][2];
  }

  // a colour, seen at a place of the image and at a distance along the view direction, through these spheres
  Colour operator()(const std::vector<std::size_t>& spheres, double x, double y, double distance,
                    const Colour& farther) const;

private:
  typedef std::array<double, 4> Box; // left, top, right, bottom

  Box box(const Sphere& s) const;
  double first_hit(const Sphere& s, const Eigen::Vector3d& ray) const;
  bool is_gap(const Sphere& s, const Eigen::Vector3d& from_centre) const;
  void draw_line(const Sphere& s, const Eigen::Vector3d& ray, double distance, Colour& colour) const;
  void draw_glass(const Sphere& s, const Eigen::Vector3d& ray, double distance, Colour& colour) const;

  std::vector<Sphere> m_spheres;
  std::vector<Box> m_boxes;
  Camera m_camera;
  Eigen::Vector3d m_to_light;
  double m_line_width;
};

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_SPHERES_H
