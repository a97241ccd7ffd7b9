// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SUPPRESS_NON_MAXIMA_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SUPPRESS_NON_MAXIMA_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Scales that differ by more than this factor are different events, even in the same place: the flexing of a knee and
// the swing of the leg. Dropping the weaker one of such a pair makes the outcome depend on which of them is stronger by
// a hair.
constexpr double like_scales = 1.5;

inline bool are_alike(double scale_1, double scale_2)
{
  return scale_1 <= like_scales * scale_2 && scale_2 <= like_scales * scale_1;
}

// Of features sorted by strength, strongest first, drops those of which a stronger one that is kept is within
// max(sigma) on the surface and max(tau) in time, at like scales. Distances on the surface are along edges.
template <class Feature>
std::vector<Feature> suppress_non_maxima(const Rest_shape& shape, const std::vector<Feature>& features)
{
  double largest_sigma = 0;
  std::vector<std::vector<std::size_t>> at_vertex(shape.number_of_vertices());
  for (std::size_t i = 0; i < features.size(); ++i) {
    largest_sigma = (std::max)(largest_sigma, features[i].sigma);
    at_vertex[features[i].vertex_index].push_back(i);
  }
  std::vector<char> dropped(features.size(), 0);
  std::vector<Feature> kept;
  Bounded_dijkstra dijkstra(shape);
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (dropped[i]) continue;
    const Feature& strong = features[i];
    kept.push_back(strong);
    const std::array<Rest_shape::Index, 1> source = {{Rest_shape::Index(strong.vertex_index)}};
    for (Rest_shape::Index v : dijkstra.run(source, largest_sigma))
      for (std::size_t j : at_vertex[v]) {
        const Feature& weak = features[j];
        if (j > i && dijkstra.distance(v) <= (std::max)(strong.sigma, weak.sigma) &&
            std::abs(strong.time - weak.time) <= (std::max)(strong.tau, weak.tau) &&
            are_alike(strong.sigma, weak.sigma) && are_alike(strong.tau, weak.tau))
          dropped[j] = 1;
      }
  }
  return kept;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SUPPRESS_NON_MAXIMA_H
