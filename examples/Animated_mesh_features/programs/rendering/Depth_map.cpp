// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Depth_map.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace Programs::Rendering {

namespace {

constexpr float beyond = 1e30f; // beyond all heights

} // namespace

Depth_map::Depth_map(const Surface& surface, const Eigen::Vector3d& centre, double radius,
                     const Eigen::Vector3d& to_light, std::size_t size)
  : m_size(int(size))
  , m_centre(centre)
  , m_scale(double(size) / (2 * radius))
  , m_away(1.5 / m_scale)
  , m_height(size * size, -beyond)
{
  const Eigen::Vector3d u = to_light.unitOrthogonal(), v = to_light.cross(u);
  for (int i = 0; i < 3; ++i) m_axes.col(i) = (m_scale * Eigen::Vector3d(u[i], v[i], to_light[i])).cast<float>();
  std::vector<Eigen::Vector3f> projected(surface.points.size());
  for (std::size_t i = 0; i < projected.size(); ++i) projected[i] = place((surface.points[i] - centre).cast<float>());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Surface::Triangle& t = surface.triangles[i];
    const int side = surface.outer_sides.empty() ? 0 : surface.outer_sides[i];
    draw(projected[t[0]], projected[t[1]], projected[t[2]], side);
  }
}

void Depth_map::draw(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c, int side)
{
  const float bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
  const float area = bx * cy - by * cx;
  if (area * float(side) < 0) return; // the other side of the body is nearer to the light
  const auto first = [this](float x) { return (std::min)(m_size, (std::max)(0, int(x + 0.5f))); };
  const int left = first((std::min)((std::min)(a[0], b[0]), c[0])),
            right = first((std::max)((std::max)(a[0], b[0]), c[0]));
  if (left >= right) return;
  const int top = first((std::min)((std::min)(a[1], b[1]), c[1])),
            bottom = first((std::max)((std::max)(a[1], b[1]), c[1]));
  if (top >= bottom || !(std::abs(area) > 1e-12f)) return;
  const float inverse = 1 / area, slack = -1e-4f; // no gaps between neighbours, whose edges round differently
  const float s_x = cy * inverse, s_y = -cx * inverse, t_x = -by * inverse, t_y = bx * inverse;
  const float bz = b[2] - a[2], cz = c[2] - a[2];
  for (int y = top; y < bottom; ++y) {
    const float dy = float(y) + 0.5f - a[1];
    float* const row = &m_height[std::size_t(y) * std::size_t(m_size)];
    for (int x = left; x < right; ++x) {
      const float dx = float(x) + 0.5f - a[0];
      const float s = s_x * dx + s_y * dy, t = t_x * dx + t_y * dy;
      // Which of so few texels are inside no processor can guess: heights that never count are faster than a branch.
      const float outside = (std::min)((std::min)(s, t), 1 - s - t) < slack ? beyond : 0.f;
      row[x] = (std::max)(row[x], a[2] + s * bz + t * cz - outside);
    }
  }
}

} // namespace Programs::Rendering
