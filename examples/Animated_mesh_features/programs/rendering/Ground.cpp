// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Ground.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace Programs::Rendering {

Ground::Ground(const Eigen::Vector3d& up, double height, const Eigen::Vector3d& centre, double radius)
  : m_up(up)
  , m_u(up.unitOrthogonal())
  , m_v(up.cross(m_u))
  , m_origin(centre + (height - centre.dot(up)) * up)
  , m_half_width(reach * radius)
  , m_light(size, size, 1)
{}

std::vector<Shading_point> Ground::points() const
{
  std::vector<Shading_point> result(size * size);
  for (std::size_t y = 0; y < size; ++y)
    for (std::size_t x = 0; x < size; ++x) {
      Shading_point& p = result[y * size + x];
      p.point = m_origin + m_half_width * (at(x) * m_u + at(y) * m_v);
      p.normal = m_up;
      // where shadows have faded away, no light is asked for
      p.least_cosine = std::hypot(at(x), at(y)) < 1 ? least_cosine : 2;
    }
  return result;
}

void Ground::set_light(const Shading* shading, const std::vector<Light>& lights)
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

float Ground::light(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray) const
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

// Weights 1/4, 1/2, 1/4 in both directions.
void Ground::smooth()
{
  Image_of<float> rows(size, size, 1);
  for (std::size_t y = 0; y < size; ++y)
    for (std::size_t x = 1; x + 1 < size; ++x)
      rows(x, y) = 0.25f * (m_light(x - 1, y) + m_light(x + 1, y)) + 0.5f * m_light(x, y);
  for (std::size_t y = 1; y + 1 < size; ++y)
    for (std::size_t x = 0; x < size; ++x)
      m_light(x, y) = 0.25f * (rows(x, y - 1) + rows(x, y + 1)) + 0.5f * rows(x, y);
}

} // namespace Programs::Rendering
