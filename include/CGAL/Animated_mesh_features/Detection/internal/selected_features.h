// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SELECTED_FEATURES_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SELECTED_FEATURES_H

#include <CGAL/Animated_mesh_features/Detection/Feature_selection.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Detection/internal/suppress_non_maxima.h>

#include <algorithm>
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
  return Feature_selection();
}

// Of all minima, strongest first, those that become features.
template <class Feature>
std::vector<Feature>
selected_features(const Rest_shape& shape, const std::vector<Feature>& minima, const Feature_selection& selection)
{
  std::vector<Feature> selected;
  if (minima.empty()) return selected;
  const double least =
      (std::max)(selection.absolute_threshold, selection.relative_threshold * minima.front().strength());
  for (const Feature& f : minima) {
    if (f.strength() < least) break;
    if (selection.accept_border_vertices || !shape.is_border(f.vertex_index)) selected.push_back(f);
  }
  return selection.suppress_non_maxima ? suppress_non_maxima(shape, selected) : selected;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SELECTED_FEATURES_H
