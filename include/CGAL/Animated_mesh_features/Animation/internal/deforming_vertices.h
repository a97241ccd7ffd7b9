// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_DEFORMING_VERTICES_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_DEFORMING_VERTICES_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The largest change of a component's edges in any frame against rest, relative: sqrt(sum (l - l0)^2 / sum l0^2). Long
// edges decide, so that the rounding of positions does not. Each frame takes part by its own sum.
template <class FT>
double largest_edge_change(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories,
                           const Surface_component& component)
{
  const std::size_t frames = trajectories.number_of_frames();
  std::vector<double> changes(frames, 0);
  double lengths = 0;
  for (Rest_shape::Index e : component.edges) {
    const Rest_shape::Index v = shape.edges()[e].source, w = shape.edges()[e].target;
    const double length = shape.lengths()[e];
    lengths += length * length;
    const FT *xv = trajectories.x.row(v), *yv = trajectories.y.row(v), *zv = trajectories.z.row(v);
    const FT *xw = trajectories.x.row(w), *yw = trajectories.y.row(w), *zw = trajectories.z.row(w);
    for (std::size_t f = 0; f < frames; ++f) {
      const double x = double(xw[f] - xv[f]), y = double(yw[f] - yv[f]), z = double(zw[f] - zv[f]);
      const double change = std::sqrt(x * x + y * y + z * z) - length;
      changes[f] += change * change;
    }
  }
  const double largest = *std::max_element(changes.begin(), changes.end());
  return lengths > 0 ? std::sqrt(largest / lengths) : std::sqrt(largest);
}

// The vertices of the components that deform, ascending: all that belong to triangles, if there is but one component,
// if none deforms, or if a change is too large for a number. What changes less than a hundredth of what changes most,
// or less than single precision tells, keeps its shape: ground, props, what is carried along.
// Complexity: O(F E) time, for more than one component.
template <class FT>
std::vector<Rest_shape::Index> deforming_vertices(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories)
{
  const double least_share = 0.01, least_change = 1e-5;
  std::vector<Surface_component> components = surface_components(shape);
  components.erase(std::remove_if(components.begin(), components.end(),
                                  [](const Surface_component& c) { return c.triangles.empty(); }),
                   components.end());
  std::vector<double> changes(components.size(), 1);
  if (components.size() > 1)
    for (std::size_t c = 0; c < components.size(); ++c)
      changes[c] = largest_edge_change(shape, trajectories, components[c]);
  const bool are_numbers = std::all_of(changes.begin(), changes.end(), [](double c) { return std::isfinite(c); });
  const double largest = *std::max_element(changes.begin(), changes.end());
  const bool are_all_alike = !are_numbers || largest <= least_change;
  std::vector<Rest_shape::Index> result;
  for (std::size_t c = 0; c < components.size(); ++c)
    if (are_all_alike || (changes[c] > least_change && changes[c] > least_share * largest))
      result.insert(result.end(), components[c].vertices.begin(), components[c].vertices.end());
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_DEFORMING_VERTICES_H
