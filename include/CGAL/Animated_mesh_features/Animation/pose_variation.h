// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_POSE_VARIATION_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_POSE_VARIATION_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Animation/internal/nearest_rotation.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

tells how far a body moves about its mean pose: the root mean square distance of its surface from the mean of all frames,
each moved rigidly to where it fits the mean best (generalised Procrustes analysis, Gower \cgalCite{gower1975}), relative
to the root mean square distance of the surface from its own centre. Some 0.01 for a body that breathes, 0.1 to 0.2 for
one that walks, 0.5 for one that falls. It does not depend on size, mesh, frame rate, and on where the body goes.

`O(N F)` time, `3 N` doubles.

\tparam FT `float` or `double`.
\param trajectories `N x F`.
\param areas of the `N` vertices, not negative: how much each counts, see `vertex_areas()`.
\returns 0 if there is no area, or the surface is a point.
\throw Option_error if there are not as many areas as vertices.
*/
template <class FT>
double pose_variation(const Vertex_trajectories<FT>& trajectories, const std::vector<double>& areas)
{
  typedef Rest_shape::Point Point;
  const std::size_t n = trajectories.number_of_vertices(), frames = trajectories.number_of_frames();
  if (areas.size() != n)
    throw Option_error("there are " + std::to_string(n) + " vertices and " + std::to_string(areas.size()) + " areas");
  const int rounds = 4; // further ones change the result by less than a hundredth
  double area = 0;
  for (double a : areas) area += a;
  if (!(area > 0) || frames == 0) return 0;
  std::vector<Point> centres(frames, Point(0, 0, 0));
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t f = 0; f < frames; ++f) centres[f] += areas[v] / area * trajectories.point(v, f);
  // The mean pose, from the first frame: what is farther from the mean is farther from that.
  std::vector<Point> mean(n);
  for (std::size_t v = 0; v < n; ++v) mean[v] = trajectories.point(v, 0) - centres[0];
  double squares = 0, size = 0;
  for (int k = 0; k < rounds; ++k) {
    std::vector<Eigen::Matrix3d> products(frames, Eigen::Matrix3d::Zero());
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t f = 0; f < frames; ++f)
        products[f] += areas[v] / area * mean[v] * (trajectories.point(v, f) - centres[f]).transpose();
    for (Eigen::Matrix3d& m : products) m = internal::nearest_rotation(m);
    squares = size = 0;
    for (std::size_t v = 0; v < n; ++v) {
      Point sum(0, 0, 0);
      double lengths = 0;
      for (std::size_t f = 0; f < frames; ++f) {
        const Point p = products[f] * (trajectories.point(v, f) - centres[f]);
        sum += p / double(frames);
        lengths += p.squaredNorm() / double(frames);
      }
      mean[v] = sum;
      squares += areas[v] / area * (lengths - sum.squaredNorm());
      size += areas[v] / area * lengths;
    }
  }
  return size > 0 && squares > 0 ? std::sqrt(squares / size) : 0;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_POSE_VARIATION_H
