// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Lights.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace Programs::Rendering {

namespace {

// `n` directions, evenly spread over the part of the sphere within `angle` (radians) of an axis, along a golden spiral.
std::vector<Eigen::Vector3d> spread_directions(const Eigen::Vector3d& axis, double angle, std::size_t n)
{
  const double golden_angle = EIGEN_PI * (3 - std::sqrt(5.));
  const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<Eigen::Vector3d> result;
  for (std::size_t i = 0; i < n; ++i) {
    const double height = 1 - (1 - std::cos(angle)) * (double(i) + 0.5) / double(n); // equal areas
    const double radius = std::sqrt((std::max)(0., 1 - height * height)), turn = golden_angle * double(i);
    result.push_back(height * axis + radius * (std::cos(turn) * u + std::sin(turn) * v));
  }
  return result;
}

} // namespace

std::vector<Light> studio_lights(const Eigen::Vector3d& up, const Eigen::Vector3d& to_camera)
{
  const Eigen::Vector3d right = up.cross(to_camera).normalized(), front = right.cross(up);
  const auto direction = [&](double azimuth, double elevation) {
    const double a = azimuth * EIGEN_PI / 180, e = elevation * EIGEN_PI / 180;
    return Eigen::Vector3d(std::cos(e) * (std::cos(a) * front + std::sin(a) * right) + std::sin(e) * up);
  };
  std::vector<Light> lights;
  const auto add = [&](const Eigen::Vector3d& axis, double opening, std::size_t n, const Colour& colour,
                       bool is_highlight) {
    for (const Eigen::Vector3d& d : spread_directions(axis, opening * EIGEN_PI / 180, n))
      lights.push_back({d, colour / float(n), is_highlight, !is_highlight});
  };
  add(direction(-38, 52), 13, 20, 0.62f * Colour(1.03f, 1.f, 0.95f), true);
  add(direction(55, 18), 25, 8, 0.17f * Colour(0.94f, 0.98f, 1.08f), false);
  add(direction(150, 38), 18, 8, 0.28f * Colour(0.97f, 0.99f, 1.05f), true);

  const std::size_t dome = 48;
  for (const Eigen::Vector3d& d : spread_directions(up, EIGEN_PI, dome)) {
    const double height = d.dot(up);
    // the sky, and what the ground gives back
    const Colour radiance = height > 0 ? mix(Colour(0.62f, 0.62f, 0.62f), Colour(0.78f, 0.8f, 0.83f), float(height))
                                       : Colour(0.36f, 0.35f, 0.33f);
    lights.push_back({d, radiance * float(4 / double(dome)) * 0.62f, false, true});
  }
  return lights;
}

} // namespace Programs::Rendering
