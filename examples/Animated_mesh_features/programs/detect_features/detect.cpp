// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/detect.h"

#include "detect_features/Search.h"
#include "detect_features/closing_step.h"
#include "detect_features/measure_deformation.h"
#include "detect_features/method_policies.h"
#include "detect_features/with_temporal_filter.h"

#include <CGAL/Animated_mesh_features/Animation/last_frame_repeats_first.h>
#include <CGAL/Animated_mesh_features/Detection/place_on_animation.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <utility>

using Programs::Field;
using Programs::Monitor;
using Programs::Sequence;
using Programs::Wanted_fields;

namespace Detect_features {

namespace {

Search_result search_features(Search search, const Method_options& o, const Method_values& values)
{
  const double diameter = search.shape.diameter();
  return with_temporal_filter(o, values, [&](const auto& filter) {
    return o.preset == Preset::PUBLISHED ? find_features(std::move(search), filter, every_smoothing_count(o))
                                         : find_features(std::move(search), filter, fixed_ratio_sampling(o, diameter));
  });
}

// Of files it was left out.
void check_period(const Sequence& sequence)
{
  const auto& animation = sequence.trajectories();
  if (AMF::last_frame_repeats_first(animation.x, animation.y, animation.z))
    throw AMF::Option_error(
        "--cyclic: the last frame repeats the first; leave it out: the first follows the last in any case");
}

} // namespace

Detection detect(const Sequence& sequence, const Method_options& o, std::size_t level_memory, Wanted_fields& fields,
                 Monitor& monitor)
{
  if (o.is_cyclic) check_period(sequence);
  Detection detection;
  detection.values = method_values(o, sequence.number_of_frames());
  Deformation deformation = measure_deformation(sequence, o, detection.values, fields, monitor);
  detection.ball_radius = deformation.ball_radius;
  detection.bounds_ball_radius = deformation.bounds_ball_radius;
  if (o.is_cyclic) detection.closing_step = closing_step(deformation.field);

  Search search{sequence.rest_shape(),
                sequence.frame_duration(),
                std::move(deformation.field),
                deformation.noise,
                fields.is_kept(Field::DEFORMATION),
                spatial_filter(o),
                Chosen_normalization{o.dimension == Dimension::SURFACE},
                o.preset != Preset::PUBLISHED,
                detection.values.selection,
                level_memory,
                monitor};
  Search_result found = search_features(std::move(search), o, detection.values);
  if (fields.is_kept(Field::DEFORMATION)) fields.keep(Field::DEFORMATION, std::move(found.field));
  for (const auto& feature : found.features) detection.features.push_back(AMF::place_on_animation(feature, sequence));
  detection.number_of_minima = found.number_of_minima;
  detection.scales = std::move(found.scales);
  detection.missing = found.missing;
  return detection;
}

} // namespace Detect_features
