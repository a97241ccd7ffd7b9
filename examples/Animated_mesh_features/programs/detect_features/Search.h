// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_SEARCH_H
#define DETECT_FEATURES_SEARCH_H

#include "detect_features/Chosen_normalization.h"
#include "detect_features/Chosen_spatial_filter.h"
#include "detect_features/Missing_features.h"
#include "detect_features/Searched_scales.h"
#include "reading/Values.h"
#include "running/Monitor.h"

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_selection.h>
#include <CGAL/Animated_mesh_features/Detection/Spatio_temporal_feature.h>
#include <CGAL/Animated_mesh_features/Scale_space/Box_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Gaussian_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Scale_sampling.h>

#include <cstddef>
#include <optional>
#include <vector>

// The second stage: a field over a rest shape in, features out.

namespace Detect_features {

// All that does not depend on the temporal filter and the response.
struct Search
{
  const AMF::Rest_shape& shape;
  double frame_duration;  // seconds
  Programs::Values field; // is taken over
  double noise;           // of the responses to it
  bool keeps_field;       // whether the result has it
  Chosen_spatial_filter spatial_filter;
  Chosen_normalization normalization;
  bool joins_equal; // whether nearly equal minima that belong together are one
  AMF::Feature_selection selection;
  std::size_t level_memory; // bytes, of the space levels
  Programs::Monitor& monitor;
};

struct Search_result
{
  std::vector<AMF::Spatio_temporal_feature<AMF::Rest_shape::Index>> features; // strongest first
  std::size_t number_of_minima;
  Searched_scales scales;
  Programs::Values field;                  // empty unless it is kept
  std::optional<Missing_features> missing; // if there are no features
};

// The sampling of the preset CALIBRATED goes with the central difference of Gaussians, that of PUBLISHED with the forward
// one. Each of these functions is compiled on its own, since a compiler takes half a minute and a gigabyte for it.
// throw Option_error, Numerical_error, Cancelled.
Search_result find_features(Search search, const AMF::Gaussian_temporal_filter&, const AMF::Fixed_ratio_sampling&);
Search_result find_features(Search search, const AMF::Gaussian_temporal_filter&, const AMF::Every_smoothing_count&);
Search_result find_features(Search search, const AMF::Box_temporal_filter&, const AMF::Fixed_ratio_sampling&);
Search_result find_features(Search search, const AMF::Box_temporal_filter&, const AMF::Every_smoothing_count&);

} // namespace Detect_features

#endif // DETECT_FEATURES_SEARCH_H
