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
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace Rendering {

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

A horizontal plane under the body that shows nothing but its shadow, which vanishes towards the horizon: the picture
keeps its plain background.
*/
class Ground
{
public:
  /// lays a ground that no light has fallen on yet.
  /// \param up unit vector
  /// \param height of the plane along `up`
  /// \param centre,radius a sphere around the surface
  Ground(const Eigen::Vector3d& up, double height, const Eigen::Vector3d& centre, double radius)
    : m_up(up)
    , m_u(up.unitOrthogonal())
    , m_v(up.cross(m_u))
    , m_origin(centre + (height - centre.dot(up)) * up)
    , m_half_width(reach * radius)
    , m_light(size, size, 1)
  {}

  static constexpr std::size_t size = 288; ///< points along each side, 1.7 % of the body's radius apart.

  /// the points at which the light is measured, `size x size`.
  std::vector<Shading_point> points() const
  {
    std::vector<Shading_point> result(size * size);
    for (std::size_t y = 0; y < size; ++y)
      for (std::size_t x = 0; x < size; ++x) {
        Shading_point& p = result[y * size + x];
        p.point = m_origin + m_half_width * (at(x) * m_u + at(y) * m_v);
        p.normal = m_up;
        p.least_cosine = least_cosine;
      }
    return result;
  }

  /// what arrives at each of the points, of all the light that there is.
  template <class ShadingIterator>
  void set_light(ShadingIterator shading, const std::vector<Light>& lights)
  {
    Colour all = Colour::Zero();
    for (const Light& l : lights) {
      const double cosine = l.direction.dot(m_up);
      if (cosine > least_cosine) all += float(cosine) * l.colour;
    }
    for (std::size_t y = 0; y < size; ++y)
      for (std::size_t x = 0; x < size; ++x) m_light(x, y) = luminance((shading++)->diffuse) / luminance(all);
    // Soft light is made of single ones, whose shadows should not be seen one by one.
    for (int i = 0; i < smoothing; ++i) smooth();
    for (std::size_t y = 0; y < size; ++y)
      for (std::size_t x = 0; x < size; ++x) {
        const double fading = (std::min)(1., (std::max)(0., (1 - std::hypot(at(x), at(y))) / (1 - full)));
        m_light(x, y) = 1 - float(fading * fading * (3 - 2 * fading)) * (1 - m_light(x, y));
      }
  }

  /// how much light there is where a ray from an eye meets the ground, as a fraction of what there is far away from the
  /// body; 1 where it does not meet it.
  float light(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray) const
  {
    const double t = (m_origin - eye).dot(m_up) / ray.dot(m_up);
    if (!(t > 0) || !(ray.dot(m_up) < 0)) return 1;
    const Eigen::Vector3d hit = eye + t * ray - m_origin;
    const double x = texel(hit.dot(m_u)), y = texel(hit.dot(m_v));
    if (!(x >= 0 && y >= 0 && x < double(size - 1) && y < double(size - 1))) return 1;
    const std::size_t i = std::size_t(x), j = std::size_t(y);
    const float s = float(x - double(i)), r = float(y - double(j));
    return (1 - r) * ((1 - s) * m_light(i, j) + s * m_light(i + 1, j)) +
           r * ((1 - s) * m_light(i, j + 1) + s * m_light(i + 1, j + 1));
  }

private:
  static constexpr double reach = 2.5;        // radii of the body, from its centre: where the longest shadows end
  static constexpr double full = 0.25;        // the part of the reach within which shadows are not faded
  static constexpr double least_cosine = 0.2; // the few single lights that are lower would draw long stripes
  static constexpr int smoothing = 14;        // steps; their Gaussian has a deviation of sqrt(n / 2) points

  static double at(std::size_t i) { return 2 * double(i) / double(size - 1) - 1; }
  double texel(double x) const { return (x / m_half_width + 1) / 2 * double(size - 1); }

  // Weights 1/4, 1/2, 1/4 in both directions.
  void smooth()
  {
    Image_of<float> rows(size, size, 1);
    for (std::size_t y = 0; y < size; ++y)
      for (std::size_t x = 1; x + 1 < size; ++x)
        rows(x, y) = 0.25f * (m_light(x - 1, y) + m_light(x + 1, y)) + 0.5f * m_light(x, y);
    for (std::size_t y = 1; y + 1 < size; ++y)
      for (std::size_t x = 0; x < size; ++x)
        m_light(x, y) = 0.25f * (rows(x, y - 1) + rows(x, y + 1)) + 0.5f * rows(x, y);
  }

  Eigen::Vector3d m_up, m_u, m_v, m_origin;
  double m_half_width;
  Image_of<float> m_light;
};

} // namespace Rendering
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_RENDERING_GROUND_H
