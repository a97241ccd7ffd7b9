// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_SURFACE_H
#define PROGRAMS_RENDERING_SURFACE_H

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace Programs::Rendering {

// What is drawn of an animation in one frame.
struct Surface
{
  typedef std::array<std::uint32_t, 3> Triangle; // of indices of points

  std::vector<Eigen::Vector3d> points;
  std::vector<Triangle> triangles;      // either side is seen
  std::vector<Eigen::Vector3d> normals; // of the vertices, length 1, or 0 where there is none
  std::vector<float> values;            // of the field, 0 to 1; empty if there is none

  // of each triangle, see CGAL::Animated_mesh_features::outer_sides(); empty: not known. What faces away from a light throws
  // no shadow of its own then.
  std::vector<std::int8_t> outer_sides;
};

// The normals of vertices: means of those of the triangles, weighted by the angle at the vertex, which makes them
// independent of how the surface is cut into triangles.
std::vector<Eigen::Vector3d> vertex_normals(const std::vector<Eigen::Vector3d>& points,
                                            const std::vector<Surface::Triangle>& triangles);

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_SURFACE_H
