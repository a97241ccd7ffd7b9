// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/detect.h"

#include "detect_features/Search.h"
#include "detect_features/measure_deformation.h"
#include "detect_features/method_policies.h"

#include <CGAL/Animated_mesh_features/Detection/place_on_animation.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Scale_space/Scale_levels.h>

#include <cmath>
#include <sstream>
#include <utility>

using Programs::Field;
using Programs::Monitor;
using Programs::Sequence;
using Programs::Wanted_fields;

namespace Detect_features {

namespace {

// Calls `use` with the temporal filter.
template <class Use>
auto with_temporal_filter(const Method_options& o, const Method_values& values, const Use& use)
{
  return o.temporal_filter == Temporal_filter::BOX ? use(AMF::Box_temporal_filter(values.box_width))
                                                   : use(AMF::Gaussian_temporal_filter());
}

AMF::Scale_levels levels_of_every_count(const Sequence& sequence, const Method_options& o)
{
  try {
    const Method_values values = method_values(o, sequence.number_of_frames());
    return with_temporal_filter(o, values, [&](const auto& filter) {
      return every_smoothing_count(o)(sequence.rest_shape(), sequence.number_of_frames(), sequence.frame_duration(),
                                      spatial_filter(o), filter);
    });
  } catch (const AMF::Option_error& e) {
    throw AMF::Option_error(std::string(e.what()) +
                            "; use --preset calibrated, or a smaller --box-width if there are too few in time");
  }
}

Search_result search_features(Search search, const Method_options& o, const Method_values& values)
{
  const double diagonal = search.shape.bounding_box_diagonal();
  return with_temporal_filter(o, values, [&](const auto& filter) {
    return o.preset == Preset::PUBLISHED ? find_features(std::move(search), filter, every_smoothing_count(o))
                                         : find_features(std::move(search), filter, fixed_ratio_sampling(o, diagonal));
  });
}

} // namespace

std::string counts_notice(const Sequence& sequence, const Method_options& o)
{
  if (o.preset != Preset::PUBLISHED) return std::string();
  const AMF::Scale_levels levels = levels_of_every_count(sequence, o);
  const std::size_t space = levels.space_variances.size() - 1, time = levels.time_variances.size() - 1;
  const double responses =
      double(sequence.number_of_vertices()) * double(sequence.number_of_frames()) * double(space) * double(time);
  const double responses_per_minute = 60 * 3e9; // of a processor of 2024; half or twice as many on others
  const double minutes = std::round(responses / responses_per_minute);
  if (minutes < 10) return std::string();
  std::ostringstream os;
  os << space << " x " << time << " smoothing counts in space and time, some " << minutes
     << " minutes of processor time; --space-counts and --time-counts take fewer\n";
  return os.str();
}

Detection detect(const Sequence& sequence, const Method_options& o, std::size_t level_memory, Wanted_fields& fields,
                 Monitor& monitor)
{
  Detection detection;
  detection.values = method_values(o, sequence.number_of_frames());
  Deformation deformation = measure_deformation(sequence, o, detection.values, fields, monitor);
  detection.ball_radius = deformation.ball_radius;

  Search search{sequence.rest_shape(),
                sequence.frame_duration(),
                std::move(deformation.field),
                deformation.noise,
                fields.is_kept(Field::DEFORMATION),
                spatial_filter(o),
                detection.values.selection,
                level_memory,
                monitor};
  Search_result found = search_features(std::move(search), o, detection.values);
  if (fields.is_kept(Field::DEFORMATION)) fields.keep(Field::DEFORMATION, std::move(found.field));
  for (const auto& feature : found.features) detection.features.push_back(AMF::place_on_animation(feature, sequence));
  detection.number_of_minima = found.number_of_minima;
  detection.scales = std::move(found.scales);
  return detection;
}

} // namespace Detect_features
