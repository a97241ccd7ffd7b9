// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_REST_POINTS_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_REST_POINTS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/internal/copy_points.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The points of a rest shape, in the order of the vertices; see copy_points().
template <class Points, class Vertex>
std::vector<Rest_shape::Point> rest_points(const Points& points, const std::vector<Vertex>& vertices,
                                           const std::string& name)
{
  std::vector<double> xyz(3 * vertices.size());
  copy_points(points, vertices, name, xyz.data());
  std::vector<Rest_shape::Point> rest(vertices.size());
  for (std::size_t v = 0; v < rest.size(); ++v) rest[v] = Rest_shape::Point(xyz[3 * v], xyz[3 * v + 1], xyz[3 * v + 2]);
  return rest;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_REST_POINTS_H
