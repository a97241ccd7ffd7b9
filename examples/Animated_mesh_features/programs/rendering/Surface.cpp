// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Surface.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace Programs::Rendering {

std::vector<Eigen::Vector3d> vertex_normals(const std::vector<Eigen::Vector3d>& points,
                                            const std::vector<Surface::Triangle>& triangles)
{
  std::vector<Eigen::Vector3d> normals(points.size(), Eigen::Vector3d::Zero());
  for (const Surface::Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d a = points[t[(i + 1) % 3]] - points[t[i]], b = points[t[(i + 2) % 3]] - points[t[i]];
      const Eigen::Vector3d n = a.cross(b);
      const double length = n.norm();
      if (length > 0) normals[t[i]] += std::atan2(length, a.dot(b)) / length * n;
    }
  for (Eigen::Vector3d& n : normals) {
    const double length = n.norm();
    if (length > 0) n /= length;
  }
  return normals;
}

} // namespace Programs::Rendering
