// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TURNED_TRIANGLES_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TURNED_TRIANGLES_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A piece of surface has a side to look to if the sum of its normals, by area, is no shorter than this part of its area:
// that of a hemisphere. Around the tip of a limb, or where it is crumpled, the sum tells nothing.
constexpr double least_side = .5;

// How many coarse triangles look away from the original around their corners, where that has a side. `normals`: of the
// original's triangles, `coarse`: of the coarse ones, as long as their areas. `vertex_of`: for each vertex of the original
// the coarse one that stands for it, or `none`.
inline std::size_t turned_triangles(const Rest_shape& rest, const std::vector<Rest_shape::Point>& normals,
                                    const std::vector<Rest_shape::Index>& vertex_of,
                                    const std::vector<Rest_shape::Triangle>& triangles,
                                    const std::vector<Rest_shape::Point>& coarse)
{
  std::size_t vertices = 0;
  for (Rest_shape::Index v : vertex_of)
    if (v != Rest_shape::none) vertices = (std::max)(vertices, std::size_t(v) + 1);
  std::vector<Rest_shape::Point> sums(vertices, Rest_shape::Point(0, 0, 0));
  std::vector<double> areas(vertices, 0);
  for (std::size_t v = 0; v < vertex_of.size(); ++v) {
    if (vertex_of[v] == Rest_shape::none) continue;
    for (Rest_shape::Index t : rest.incident_triangles()[v]) {
      sums[vertex_of[v]] += normals[t];
      areas[vertex_of[v]] += normals[t].norm();
    }
  }
  std::size_t turned = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Rest_shape::Point sum(0, 0, 0);
    double area = 0;
    for (Rest_shape::Index v : triangles[t]) {
      if (v >= vertices) continue;
      sum += sums[v];
      area += areas[v];
    }
    if (sum.norm() >= least_side * area && sum.dot(coarse[t]) < 0) ++turned;
  }
  return turned;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TURNED_TRIANGLES_H
