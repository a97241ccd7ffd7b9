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

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

// Private to the units that define a find_features().

namespace Detect_features {

// Asks the detector, which found no features, for what tells why.
template <class Detector>
Missing_features missing_features(Detector& detector, const Search& search)
{
  Missing_features m;
  m.noise = search.noise;
  const Programs::Values& field = detector.field();
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f)
      if (field(v, f) > m.deformation) m = {double(field(v, f)), v, f, m.noise, 0, 0};
  if (detector.number_of_minima() == 0) return m;
  AMF::Feature_selection strongest_only;
  strongest_only.absolute_threshold = strongest_only.min_fit = 0;
  strongest_only.most_features = 1;
  detector.selection() = strongest_only;
  std::vector<typename Detector::Feature> strongest;
  detector(std::back_inserter(strongest), search.monitor);
  if (!strongest.empty()) {
    m.strength = strongest.front().strength;
    m.fit = strongest.front().fit;
  }
  return m;
}

template <class Response, class TemporalFilter, class Sampling>
Search_result find_features_with(Search& search, const TemporalFilter& filter, const Sampling& sampling)
{
  AMF::Extremum_options<Chosen_spatial_filter, TemporalFilter, Sampling, Response, AMF::Difference_of_gaussians_minima,
                        Chosen_normalization>
      options;
  options.spatial_filter = std::move(search.spatial_filter);
  options.temporal_filter = filter;
  options.sampling = sampling;
  options.search.join_equal = search.joins_equal;
  options.normalization = search.normalization;
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
  if (result.features.empty()) result.missing = missing_features(detector, search);
  if (search.keeps_field) result.field = detector.field();
  return result;
}

} // namespace Detect_features

#endif // DETECT_FEATURES_FIND_FEATURES_WITH_H
