// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/method_policies.h"

#include <CGAL/Animated_mesh_features/Detection/Detection_options.h>

namespace Detect_features {

namespace {

template <class Preset_options>
Method_values values_of(const Preset_options& preset)
{
  return {preset.alpha, preset.triangle_weights, preset.selection, 0};
}

} // namespace

Method_values method_values(const Method_options& o, std::size_t number_of_frames)
{
  const bool is_published = o.preset == Preset::PUBLISHED;
  const std::size_t published_width = AMF::published_box_width(number_of_frames);
  Method_values v =
      is_published ? values_of(AMF::published_options(published_width)) : values_of(AMF::calibrated_options());
  if (o.alpha) v.alpha = *o.alpha;
  if (is_published && o.temporal_filter == Temporal_filter::BOX) v.box_width = o.box_width.value_or(published_width);
  if (o.threshold || o.relative_threshold) {
    v.selection.absolute_threshold = o.threshold.value_or(0);
    v.selection.relative_threshold = o.relative_threshold.value_or(0);
  }
  if (o.min_fit) v.selection.min_fit = *o.min_fit;
  if (o.top) v.selection.most_features = *o.top;
  if (o.no_suppression) v.selection.suppress_non_maxima = false;
  return v;
}

Chosen_spatial_filter spatial_filter(const Method_options& o)
{
  if (o.spatial_filter == Spatial_filter::HEAT) return Chosen_spatial_filter(AMF::Heat_diffusion_filter());
  // The paper has one scale for all vertices.
  return Chosen_spatial_filter(AMF::One_ring_average_filter(o.preset != Preset::PUBLISHED));
}

AMF::Fixed_ratio_sampling fixed_ratio_sampling(const Method_options& o, double diameter)
{
  AMF::Fixed_ratio_sampling sampling;
  if (o.sigma.min) sampling.sigma.min = o.sigma.min->on(diameter);
  if (o.sigma.max) sampling.sigma.max = o.sigma.max->on(diameter);
  if (o.tau.min) sampling.tau.min = *o.tau.min;
  if (o.tau.max) sampling.tau.max = *o.tau.max;
  return sampling;
}

AMF::Every_smoothing_count every_smoothing_count(const Method_options& o)
{
  AMF::Every_smoothing_count sampling;
  sampling.max_space_count = o.space_counts.value_or(0);
  sampling.max_time_count = o.time_counts.value_or(0);
  return sampling;
}

} // namespace Detect_features
