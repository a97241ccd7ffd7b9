// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_GROUND_H
#define PROGRAMS_RENDERING_GROUND_H

#include "rendering/Illumination.h"
#include "rendering/Image.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace Programs::Rendering {

// A horizontal plane under the body that shows nothing but its shadow, which vanishes towards the horizon: the picture
// keeps its plain background.
class Ground
{
public:
  // A ground that no light has fallen on yet: `up` is a unit vector, `height` that of the plane along it, `centre` and
  // `radius` are of a sphere around the surface.
  Ground(const Eigen::Vector3d& up, double height, const Eigen::Vector3d& centre, double radius);

  static constexpr std::size_t size = 112; // points along each side, 4.5 % of the body's radius apart

  // the points at which the light is measured, `size x size`
  std::vector<Shading_point> points() const;

  // what arrives at each of the points, of all the light that there is
  void set_light(const Shading* shading, const std::vector<Light>& lights);

  // How much light there is where a ray from an eye meets the ground, as a fraction of what there is far away from the
  // body; 1 where it does not meet it.
  float light(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray) const;

private:
  static constexpr double reach = 2.5;        // radii of the body, from its centre: where the longest shadows end
  static constexpr double full = 0.25;        // the part of the reach within which shadows are not faded
  static constexpr double least_cosine = 0.2; // the few single lights that are lower would draw long stripes
  static constexpr int smoothing = 3;         // steps; their Gaussian has a deviation of sqrt(n / 2) points

  static double at(std::size_t i) { return 2 * double(i) / double(size - 1) - 1; }
  double texel(double x) const { return (x / m_half_width + 1) / 2 * double(size - 1); }
  void smooth();

  Eigen::Vector3d m_up, m_u, m_v, m_origin;
  double m_half_width;
  Image_of<float> m_light;
};

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_GROUND_H
