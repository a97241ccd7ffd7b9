// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/check_scales.h"

#include "detect_features/method_policies.h"
#include "detect_features/with_temporal_filter.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Scale_space/Scale_levels.h>

#include <cmath>
#include <cstddef>
#include <sstream>

namespace AMF = CGAL::Animated_mesh_features;

using Programs::Sequence;

namespace Detect_features {

namespace {

AMF::Scale_levels levels_of_every_count(const Sequence& sequence, const Method_options& o)
{
  const Method_values values = method_values(o, sequence.number_of_frames());
  return with_temporal_filter(o, values, [&](const auto& filter) {
    return every_smoothing_count(o)(sequence.rest_shape(), sequence.number_of_frames(), sequence.frame_duration(),
                                    spatial_filter(o), filter);
  });
}

void choose_fixed_levels(const Sequence& sequence, const Method_options& o)
{
  const AMF::Rest_shape& shape = sequence.rest_shape();
  with_temporal_filter(o, method_values(o, sequence.number_of_frames()), [&](const auto& filter) {
    return fixed_ratio_sampling(o, shape.diameter())(shape, sequence.number_of_frames(), sequence.frame_duration(),
                                                     spatial_filter(o), filter);
  });
}

// Features are found two levels above what the filter can make: see Fixed_ratio_sampling.
double smallest_resolved_sigma(const AMF::Rest_shape& shape, const Method_options& o)
{
  const double ratio = AMF::Fixed_ratio_sampling().sigma_ratio;
  return ratio * ratio * std::sqrt(spatial_filter(o).smallest_variance(shape));
}

// The mesh is at fault, unless somebody typed a limit.
void check_counts(const Sequence& sequence, const Method_options& o, const std::string& file)
{
  try {
    levels_of_every_count(sequence, o);
  } catch (const AMF::Option_error& e) {
    const std::string what =
        std::string(e.what()) + "; use --preset calibrated, or a smaller --box-width if there are too few in time";
    if (o.space_counts || o.time_counts || o.box_width) throw AMF::Option_error(what);
    throw AMF::Input_error(file + ": " + what + "; of the mesh, " + coarse_mesh(sequence.rest_shape(), o));
  }
}

void check_ranges(const Sequence& sequence, const Method_options& o, const std::string& file)
{
  Method_options space_only = o;
  space_only.tau = {};
  try {
    choose_fixed_levels(sequence, space_only);
  } catch (const AMF::Option_error& e) {
    if (!o.sigma.text.empty()) throw; // as it was typed
    throw AMF::Input_error(file + ": the mesh is too coarse: " + e.what() + "; " +
                           coarse_mesh(sequence.rest_shape(), o));
  }
  choose_fixed_levels(sequence, o); // what is wrong now was typed
}

} // namespace

void check_scales(const Sequence& sequence, const Method_options& o, const std::string& file)
{
  if (!(sequence.rest_shape().diameter() > 0))
    throw AMF::Input_error(file + ": the rest shape has no extent: all vertices are at one point");
  if (o.preset == Preset::PUBLISHED)
    check_counts(sequence, o, file);
  else
    check_ranges(sequence, o, file);
}

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

bool is_smallest_resolved(const AMF::Rest_shape& shape, const Method_options& o, double sigma)
{
  return o.preset == Preset::CALIBRATED &&
         sigma < AMF::Fixed_ratio_sampling().sigma_ratio * smallest_resolved_sigma(shape, o) * (1 + 1e-9);
}

bool is_limited_by_mesh(const AMF::Rest_shape& shape, const Method_options& o, double smallest_sigma)
{
  const double coarse = 0.05; // of the diagonal: ten edges for a limb
  return shape.mean_edge_length() > coarse * shape.bounding_box_diagonal() &&
         is_smallest_resolved(shape, o, smallest_sigma);
}

std::string coarse_mesh(const AMF::Rest_shape& shape, const Method_options& o)
{
  const double smallest = smallest_resolved_sigma(shape, o), edge = shape.mean_edge_length();
  std::ostringstream os;
  os.precision(3);
  os << "its mean edge, " << edge << ", is " << 100 * edge / shape.bounding_box_diagonal() << " % of the diagonal";
  if (o.preset == Preset::PUBLISHED)
    os << "; subdivide it";
  else
    os << ", so that nothing below sigma " << smallest
       << " is found; subdivide it (each time halves that), or look for larger features: --sigma-range "
       << 1.01 * smallest << ':' << 4 * smallest;
  return os.str();
}

} // namespace Detect_features
