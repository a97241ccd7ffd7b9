// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_SURFACE_H
#define PROGRAMS_RENDERING_SURFACE_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace Rendering {

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

what is drawn of an animation in one frame.
*/
struct Surface
{
  typedef std::array<std::uint32_t, 3> Triangle; ///< of indices of points

  std::vector<Eigen::Vector3d> points;  ///< positions of the vertices.
  std::vector<Triangle> triangles;      ///< either side is seen.
  std::vector<Eigen::Vector3d> normals; ///< of the vertices, length 1, or 0 where there is none.
  std::vector<float> values;            ///< of the field, 0 to 1; empty if there is none.
};

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

the normals of vertices: means of those of the triangles, weighted by the angle at the vertex, which makes them
independent of how the surface is cut into triangles.
*/
inline std::vector<Eigen::Vector3d> vertex_normals(const std::vector<Eigen::Vector3d>& points,
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

} // namespace Rendering
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_RENDERING_SURFACE_H
