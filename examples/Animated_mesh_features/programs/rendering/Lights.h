// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_LIGHTS_H
#define PROGRAMS_RENDERING_LIGHTS_H

#include "rendering/Colour.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace Rendering {

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

light from infinitely far away. Soft light is made of many of them.
*/
struct Light
{
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY(); ///< towards the light, length 1.
  Colour colour = Colour::Zero();                       ///< irradiance of a surface that faces it.
  bool is_highlight = false;                            ///< whether it is reflected as a highlight.
};

namespace internal {

// `n` directions, evenly spread over the part of the sphere within `angle` (radians) of an axis, along a golden spiral.
inline std::vector<Eigen::Vector3d> spread_directions(const Eigen::Vector3d& axis, double angle, std::size_t n)
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

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

the lights of a studio: a large key light above one shoulder of the camera, a fill light at the other, a rim light
behind the body, and a dome of dim light all around, whose shadows are what is called ambient occlusion. A white surface
that faces the key light gets about 1.

\param up,to_camera unit vectors
*/
inline std::vector<Light> studio_lights(const Eigen::Vector3d& up, const Eigen::Vector3d& to_camera)
{
  const Eigen::Vector3d right = up.cross(to_camera).normalized(), front = right.cross(up);
  const auto direction = [&](double azimuth, double elevation) {
    const double a = azimuth * EIGEN_PI / 180, e = elevation * EIGEN_PI / 180;
    return Eigen::Vector3d(std::cos(e) * (std::cos(a) * front + std::sin(a) * right) + std::sin(e) * up);
  };
  std::vector<Light> lights;
  const auto add = [&](const Eigen::Vector3d& axis, double opening, std::size_t n, const Colour& colour,
                       bool is_highlight) {
    for (const Eigen::Vector3d& d : internal::spread_directions(axis, opening * EIGEN_PI / 180, n))
      lights.push_back({d, colour / float(n), is_highlight});
  };
  add(direction(-38, 52), 13, 40, 0.62f * Colour(1.03f, 1.f, 0.95f), true);
  add(direction(55, 18), 25, 16, 0.17f * Colour(0.94f, 0.98f, 1.08f), false);
  add(direction(150, 38), 18, 16, 0.28f * Colour(0.97f, 0.99f, 1.05f), true);

  const std::size_t dome = 112;
  for (const Eigen::Vector3d& d : internal::spread_directions(up, EIGEN_PI, dome)) {
    const double height = d.dot(up);
    // the sky, and what the ground gives back
    const Colour radiance = height > 0 ? mix(Colour(0.62f, 0.62f, 0.62f), Colour(0.78f, 0.8f, 0.83f), float(height))
                                       : Colour(0.36f, 0.35f, 0.33f);
    lights.push_back({d, radiance * float(4 / double(dome)) * 0.62f, false});
  }
  return lights;
}

} // namespace Rendering
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_RENDERING_LIGHTS_H
