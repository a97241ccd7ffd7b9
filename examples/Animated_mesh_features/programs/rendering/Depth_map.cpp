// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Depth_map.h"

#include "rendering/Triangle_scan.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace Programs::Rendering {

Depth_map::Depth_map(const Surface& surface, const Eigen::Vector3d& centre, double radius,
                     const Eigen::Vector3d& to_light)
  : m_u(to_light.unitOrthogonal())
  , m_v(to_light.cross(m_u))
  , m_w(to_light)
  , m_centre(centre)
  , m_scale(double(size) / (2 * radius))
  , m_height(std::size_t(size * size), -(std::numeric_limits<float>::max)())
{
  std::vector<Eigen::Vector3d> projected(surface.points.size());
  for (std::size_t i = 0; i < projected.size(); ++i) projected[i] = place(surface.points[i]);
  for (const Surface::Triangle& t : surface.triangles)
    Triangle_scan(projected[t[0]], projected[t[1]], projected[t[2]])(1, 0, size, 0, size,
                                                                     [this](long x, long y, double height) {
                                                                       float& h = m_height[std::size_t(y * size + x)];
                                                                       h = (std::max)(h, float(height));
                                                                     });
}

} // namespace Programs::Rendering
