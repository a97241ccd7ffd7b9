// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_FIND_FEATURES_WITH_H
#define DETECT_FEATURES_FIND_FEATURES_WITH_H

#include "detect_features/Search.h"

#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Animated_mesh_features/Extrema/Extremum_options.h>
#include <CGAL/Animated_mesh_features/Scale_space/Difference_of_gaussians.h>

#include <iterator>
#include <utility>

// Private to the units that define a find_features().

namespace Detect_features {

template <class Response, class TemporalFilter, class Sampling>
Search_result find_features_with(Search& search, const TemporalFilter& filter, const Sampling& sampling)
{
  AMF::Extremum_options<Chosen_spatial_filter, TemporalFilter, Sampling, Response> options;
  options.spatial_filter = std::move(search.spatial_filter);
  options.temporal_filter = filter;
  options.sampling = sampling;
  options.level_memory = search.level_memory;
  AMF::Feature_detector<Programs::FT, decltype(options)> detector(search.shape, std::move(search.field),
                                                                  search.frame_duration, options, search.noise);
  detector.selection() = search.selection;

  Search_result result;
  detector(std::back_inserter(result.features), search.monitor);
  result.number_of_minima = detector.number_of_minima();
  result.scales.sigma_levels = detector.sigma_levels();
  result.scales.tau_levels = detector.tau_levels();
  // a response needs levels on either side, an extremum needs responses
  result.scales.levels_below = Response::below + 1;
  result.scales.levels_above = Response::above + 1;
  if (search.keeps_field) result.field = detector.field();
  return result;
}

} // namespace Detect_features

#endif // DETECT_FEATURES_FIND_FEATURES_WITH_H
