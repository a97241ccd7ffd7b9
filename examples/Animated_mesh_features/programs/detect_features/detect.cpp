// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/detect.h"

#include "detect_features/Chosen_policies.h"

#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Animated_mesh_features/Detection/place_on_animation.h>

#include <cmath>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace Detect_features {

namespace {

typedef AMF::Spatio_temporal_field<FT> Values;

// 0: the box follows the scales, or there is none.
std::size_t box_width(const Sequence& sequence, const Command_line& c)
{
  if (c.preset != Preset::PUBLISHED || c.temporal_filter != Temporal_filter::BOX) return 0;
  return c.box_width.value_or(AMF::published_box_width(sequence.number_of_frames()));
}

// What the two presets differ in, besides what the command line chooses by name.
void set_defaults(const Sequence& sequence, const Command_line& c, Detection& result)
{
  const AMF::Published_options published =
      AMF::published_options(AMF::published_box_width(sequence.number_of_frames()));
  const AMF::Calibrated_options calibrated = AMF::calibrated_options();
  const bool is_published = c.preset == Preset::PUBLISHED;
  result.triangle_weights = is_published ? published.triangle_weights : calibrated.triangle_weights;
  result.selection = is_published ? published.selection : calibrated.selection;
  result.alpha = c.alpha.value_or(is_published ? published.alpha : calibrated.alpha);
  result.box_width = box_width(sequence, c);
  if (c.threshold) result.selection.relative_threshold = *c.threshold;
  if (c.absolute_threshold) result.selection.absolute_threshold = *c.absolute_threshold;
  if (c.no_suppression) result.selection.suppress_non_maxima = false;
}

// The deformation of all vertices in all frames; on the way, the fields are written, and kept if they are to be shown.
template <class CurvatureMeasure>
Values deformation(const Sequence& sequence, const Command_line& c, const CurvatureMeasure& curvature,
                   Detection& result, Result_files& files, Monitor& monitor)
{
  AMF::Deformation_options<Chosen_strain, CurvatureMeasure, Chosen_balls> options;
  options.strain = Chosen_strain(c.strain);
  options.curvature = curvature;
  options.balls = Chosen_balls(c.balls);
  const auto is_wanted = [&](Field kind) { return c.is_written(kind) || c.is_shown(kind); };
  options.triangle_weights = result.triangle_weights;
  options.alpha = result.alpha;
  if (options.alpha != 0 || is_wanted(Field::CURVATURE))
    result.ball_radius = c.ball_radius ? c.ball_radius->on(sequence.rest_shape().bounding_box_diagonal())
                                       : AMF::default_ball_radius(sequence.rest_shape());
  options.ball_radius = result.ball_radius;
  AMF::Deformation_measurement<Sequence, decltype(options)> measurement(sequence, options);

  const auto write = [&](Field kind, const Values& field) {
    if (!c.is_written(kind)) return;
    const Stage_log::Scope stage(monitor.log(), "writing");
    files.write_field(kind, field);
  };
  const auto use = [&](Field kind, const Values& field) {
    write(kind, field);
    if (c.is_shown(kind)) result.shown_fields.push_back({kind, field});
  };
  if (is_wanted(Field::STRAIN)) use(Field::STRAIN, measurement.strain(monitor));
  if (is_wanted(Field::CURVATURE)) use(Field::CURVATURE, measurement.curvature_change(monitor));
  Values sum = measurement.take_deformation(monitor);
  result.deformation_noise = measurement.noise();
  write(Field::DEFORMATION, sum); // kept by the detector of features as long as it takes
  return sum;
}

template <class TemporalFilter, class Sampling, class Response>
void find_features(const Sequence& sequence, const Command_line& c, Values deformation, const Chosen_spatial_filter& spatial,
                   const TemporalFilter& temporal, const Sampling& sampling, const Response& response,
                   std::size_t level_memory, Detection& result, Monitor& monitor)
{
  AMF::Extremum_options<Chosen_spatial_filter, TemporalFilter, Sampling, Response> options;
  options.spatial_filter = spatial;
  options.temporal_filter = temporal;
  options.sampling = sampling;
  options.response = response;
  options.level_memory = level_memory;
  AMF::Feature_detector<FT, decltype(options)> detector(sequence.rest_shape(), std::move(deformation),
                                                        sequence.frame_duration(), options, result.deformation_noise);
  detector.selection() = result.selection;
  std::vector<AMF::Spatio_temporal_feature<AMF::Rest_shape::Index>> features;
  detector(std::back_inserter(features), monitor);
  for (const auto& feature : features) result.features.push_back(AMF::place_on_animation(feature, sequence));
  if (c.is_shown(Field::DEFORMATION)) // first: it is what features are features of
    result.shown_fields.insert(result.shown_fields.begin(), {Field::DEFORMATION, detector.field()});
  result.number_of_minima = detector.number_of_minima();
  result.sigma_levels = detector.sigma_levels();
  result.tau_levels = detector.tau_levels();
  // a response needs levels on either side, an extremum needs responses
  result.levels_below = Response::below + 1;
  result.levels_above = Response::above + 1;
}

AMF::Fixed_ratio_sampling fixed_ratio_sampling(const Sequence& sequence, const Command_line& c)
{
  const double diagonal = sequence.rest_shape().bounding_box_diagonal();
  AMF::Fixed_ratio_sampling sampling;
  if (c.sigma.min) sampling.sigma.min = c.sigma.min->on(diagonal);
  if (c.sigma.max) sampling.sigma.max = c.sigma.max->on(diagonal);
  if (c.tau.min) sampling.tau.min = *c.tau.min;
  if (c.tau.max) sampling.tau.max = *c.tau.max;
  return sampling;
}

Chosen_spatial_filter spatial_filter(const Command_line& c)
{
  if (c.spatial_filter == Spatial_filter::HEAT) return Chosen_spatial_filter(AMF::Heat_diffusion_filter());
  // The paper has one scale for all vertices.
  return Chosen_spatial_filter(AMF::One_ring_average_filter(c.preset != Preset::PUBLISHED));
}

AMF::Every_smoothing_count every_smoothing_count(const Command_line& c)
{
  AMF::Every_smoothing_count sampling;
  sampling.max_space_count = c.space_counts.value_or(0);
  sampling.max_time_count = c.time_counts.value_or(0);
  return sampling;
}

AMF::Scale_levels levels_of_every_count(const Sequence& sequence, const Command_line& c)
{
  const auto levels = [&](const auto& temporal) {
    return every_smoothing_count(c)(sequence.rest_shape(), sequence.number_of_frames(), sequence.frame_duration(),
                                    spatial_filter(c), temporal);
  };
  try {
    if (c.temporal_filter == Temporal_filter::BOX) return levels(AMF::Box_temporal_filter(box_width(sequence, c)));
    return levels(AMF::Gaussian_temporal_filter());
  } catch (const AMF::Option_error& e) {
    throw AMF::Option_error(std::string(e.what()) +
                            "; use --preset calibrated, or a smaller --box-width if there are too few in time");
  }
}

} // namespace

std::string counts_notice(const Sequence& sequence, const Command_line& c)
{
  if (c.preset != Preset::PUBLISHED) return std::string();
  const AMF::Scale_levels levels = levels_of_every_count(sequence, c);
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

Detection detect(const Sequence& sequence, const Command_line& c, std::size_t level_memory, Result_files& files,
                 Monitor& monitor)
{
  Detection result;
  set_defaults(sequence, c, result);
  Values field = c.curvature == Curvature::DENSITY
                     ? deformation(sequence, c, AMF::Mean_curvature_density(), result, files, monitor)
                     : deformation(sequence, c, AMF::Mean_dihedral_angle(), result, files, monitor);

  const bool is_published = c.preset == Preset::PUBLISHED;
  const Chosen_spatial_filter spatial = spatial_filter(c);
  const auto find = [&](const auto& temporal) {
    if (is_published)
      find_features(sequence, c, std::move(field), spatial, temporal, every_smoothing_count(c),
                    AMF::Forward_difference_of_gaussians(), level_memory, result, monitor);
    else
      find_features(sequence, c, std::move(field), spatial, temporal, fixed_ratio_sampling(sequence, c),
                    AMF::Central_difference_of_gaussians(), level_memory, result, monitor);
  };
  if (c.temporal_filter == Temporal_filter::BOX)
    find(AMF::Box_temporal_filter(result.box_width));
  else
    find(AMF::Gaussian_temporal_filter());
  return result;
}

} // namespace Detect_features
