// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSED_SURFACE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSED_SURFACE_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A surface in one frame, moved and scaled into the unit sphere: views follow the body.
struct Posed_surface
{
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); // of its bounding box
  double radius = 1;                                // of the sphere around the centre
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f>
      normals; // of vertices: means of those of the triangles, weighted by area; 0 if there is none
};

inline void set_points(Posed_surface& s, const Rest_shape& shape, const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d low = points[shape.triangles().front()[0]], high = low;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!shape.is_isolated(v)) low = low.cwiseMin(points[v]), high = high.cwiseMax(points[v]);
  s.centre = (low + high) / 2;
  double squared = 0;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!shape.is_isolated(v)) squared = (std::max)(squared, (points[v] - s.centre).squaredNorm());
  s.radius = squared > 0 ? std::sqrt(squared) : 1;
  s.points.resize(points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    s.points[v] = shape.is_isolated(v) ? Eigen::Vector3f(Eigen::Vector3f::Zero())
                                       : Eigen::Vector3f(((points[v] - s.centre) / s.radius).cast<float>());
  std::vector<Eigen::Vector3d> sums(points.size(), Eigen::Vector3d::Zero());
  // in an order that does not depend on that of faces(mesh)
  for (Rest_shape::Index i : shape.ordered_triangles()) {
    const Rest_shape::Triangle& t = shape.triangles()[i];
    const Eigen::Vector3d n = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
    for (Rest_shape::Index v : t) sums[v] += n;
  }
  s.normals.resize(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const double length = sums[v].norm();
    s.normals[v] =
        length > 0 ? Eigen::Vector3f((sums[v] / length).cast<float>()) : Eigen::Vector3f(Eigen::Vector3f::Zero());
  }
}

template <class FT>
Posed_surface posed_surface(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories, std::size_t frame)
{
  Posed_surface result;
  set_points(result, shape, trajectories.frame(frame).points());
  return result;
}

} // namespace internal

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSED_SURFACE_H
