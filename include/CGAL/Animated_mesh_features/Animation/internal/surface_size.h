// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_SIZE_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_SIZE_H

#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// How large a surface is, see Rest_shape.
struct Surface_size
{
  double mean_edge_length = 0, diagonal = 0, diameter = 0;
};

// By its measured vertices, of which there is one at least, and the edges that begin at one.
template <class Edge, class Index>
Surface_size surface_size(const std::vector<Eigen::Vector3d>& positions, const std::vector<Edge>& edges,
                          const std::vector<double>& lengths, const std::vector<Index>& measured)
{
  Surface_size result;
  std::vector<char> is_measured(positions.size(), 0);
  for (Index v : measured) is_measured[v] = 1;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (is_measured[edges[i].source] == 0) continue;
    sum += lengths[i];
    ++count;
  }
  result.mean_edge_length = sum / double(count);
  Eigen::Vector3d low = positions[measured.front()], high = low;
  typedef CGAL::Simple_cartesian<double> Kernel;
  std::vector<Kernel::Point_3> points;
  points.reserve(measured.size());
  for (Index v : measured) {
    const Eigen::Vector3d& p = positions[v];
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    points.emplace_back(p[0], p[1], p[2]);
  }
  result.diagonal = (high - low).norm();
  CGAL::Min_sphere_of_spheres_d<CGAL::Min_sphere_of_points_d_traits_3<Kernel, double>> sphere(points.begin(),
                                                                                              points.end());
  result.diameter = 2 * CGAL::to_double(sphere.radius());
  return result;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_SIZE_H
