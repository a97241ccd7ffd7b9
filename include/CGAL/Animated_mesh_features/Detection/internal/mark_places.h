// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_MARK_PLACES_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_MARK_PLACES_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Detection/internal/Time_difference.h>
#include <CGAL/Animated_mesh_features/Detection/internal/suppress_non_maxima.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Whether `inner` lies in the simultaneous event of another scale `outer`, `distance` away on the surface.
template <class Feature>
bool lies_in(const Feature& inner, const Feature& outer, double distance, const Time_difference& between)
{
  return distance <= outer.radius() && between(inner.time, outer.time) <= outer.tau &&
         !(are_alike(inner.sigma, outer.sigma) && are_alike(inner.tau, outer.tau));
}

// Whether `feature` is at the place of which `first` is the strongest feature: nearer than the larger of the two sigmas,
// which are alike.
template <class Feature>
bool is_same_place(const Feature& feature, const Feature& first, double distance)
{
  return distance <= (std::max)(feature.sigma, first.sigma) && are_alike(feature.sigma, first.sigma);
}

// Numbers the places of features, which are sorted by strength, strongest first, and tells for each the strongest in which
// it lies. Distances are along edges, those in time `between` two. A ball of the surface for each feature.
template <class Feature>
void mark_places(const Rest_shape& shape, std::vector<Feature>& features,
                 const Time_difference& between = Time_difference())
{
  std::unordered_map<std::size_t, std::vector<std::size_t>> at_vertex;
  for (std::size_t i = 0; i < features.size(); ++i) {
    at_vertex[features[i].vertex_index].push_back(i);
    features[i].parent = Feature::none;
  }
  const std::size_t unknown = features.size();
  std::vector<std::size_t> place(features.size(), unknown);
  std::size_t places = 0;
  Bounded_dijkstra dijkstra(shape);
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Feature& f = features[i];
    const bool is_first = place[i] == unknown;
    if (is_first) place[i] = places++;
    const std::array<Rest_shape::Index, 1> source = {{Rest_shape::Index(f.vertex_index)}};
    for (Rest_shape::Index v : dijkstra.run(source, like_scales * f.sigma)) {
      const auto here = at_vertex.find(v);
      if (here == at_vertex.end()) continue;
      for (std::size_t j : here->second) {
        if (j <= i) continue;
        if (is_first && place[j] == unknown && is_same_place(features[j], f, dijkstra.distance(v))) place[j] = place[i];
        if (features[j].parent == Feature::none && lies_in(features[j], f, dijkstra.distance(v), between))
          features[j].parent = i;
      }
    }
  }
  for (std::size_t i = 0; i < features.size(); ++i) features[i].place = place[i];
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_MARK_PLACES_H
