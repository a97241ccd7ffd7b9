// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SELECTED_FEATURES_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SELECTED_FEATURES_H

#include <CGAL/Animated_mesh_features/Detection/Feature_selection.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Detection/internal/Time_difference.h>
#include <CGAL/Animated_mesh_features/Detection/internal/mark_places.h>
#include <CGAL/Animated_mesh_features/Detection/internal/suppress_non_maxima.h>
#include <CGAL/Animated_mesh_features/Detection/internal/suppress_overlapped.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The selection that options bring, if they do: those of a whole detection do, those of a search do not.
template <class Options>
auto selection_of(const Options& options, int) -> decltype(Feature_selection(options.selection))
{
  return options.selection;
}
template <class Options>
Feature_selection selection_of(const Options&, long)
{
  return Feature_selection::of_any_field();
}

// Of minima that are strong enough those that become features, strongest first.
template <class Feature>
std::vector<Feature> selected_features(const Rest_shape& shape, std::vector<Feature> minima,
                                       const Feature_selection& selection,
                                       const Time_difference& between = Time_difference())
{
  double strongest = 0;
  for (const Feature& f : minima) strongest = (std::max)(strongest, f.strength);
  const auto is_left_out = [&](const Feature& f) {
    return (selection.min_fit > 0 && !(f.fit >= selection.min_fit)) ||
           (!selection.accept_border_vertices && shape.is_border(f.vertex_index));
  };
  minima.erase(std::remove_if(minima.begin(), minima.end(), is_left_out), minima.end());
  std::sort(minima.begin(), minima.end(), [](const Feature& a, const Feature& b) {
    return std::tie(b.strength, a.vertex_index, a.time, a.sigma, a.tau) <
           std::tie(a.strength, b.vertex_index, b.time, b.sigma, b.tau);
  });
  if (selection.suppress_non_maxima) {
    minima = suppress_non_maxima(shape, minima, between);
    const double least = selection.least_strength(strongest);
    if (least > 0) minima = Overlap_suppression<Feature>(shape, minima, between).kept(least);
  }
  if (minima.size() > selection.most_features) minima.resize(selection.most_features);
  mark_places(shape, minima, between);
  return minima;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SELECTED_FEATURES_H
