// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_METHOD_OPTIONS_H
#define DETECT_FEATURES_METHOD_OPTIONS_H

#include "options/Length.h"
#include "options/Names.h"
#include "options/Range.h"

#include <cstddef>
#include <optional>

namespace Programs {
class Option_group;
}

namespace Detect_features {

enum class Preset
{
  CALIBRATED,
  PUBLISHED
};
enum class Strain
{
  HENCKY,
  GREEN_LAGRANGE,
  STRETCH,
  LARGEST_EIGENVALUE
};
enum class Curvature
{
  DENSITY,
  DIHEDRAL
};
enum class Balls
{
  HEAT,
  HEAT_PATCHES,
  HEAT_GLOBAL,
  DIJKSTRA
};
enum class Spatial_filter
{
  HEAT,
  ONE_RING
};
enum class Temporal_filter
{
  GAUSSIAN,
  BOX
};
enum class Baseline
{
  LEAST,
  NONE
};
enum class Dimension
{
  SURFACE,
  PLANE
};

Programs::Names<Preset> names(Preset);
Programs::Names<Strain> names(Strain);
Programs::Names<Curvature> names(Curvature);
Programs::Names<Balls> names(Balls);
Programs::Names<Spatial_filter> names(Spatial_filter);
Programs::Names<Temporal_filter> names(Temporal_filter);
Programs::Names<Baseline> names(Baseline);
Programs::Names<Dimension> names(Dimension);

// How features are found. What is not chosen is as the preset has it, or follows from the animation: see Method_values.
struct Method_options
{
  Preset preset = Preset::CALIBRATED;
  Strain strain = Strain::HENCKY;
  Curvature curvature = Curvature::DENSITY;
  Balls balls = Balls::HEAT;
  Spatial_filter spatial_filter = Spatial_filter::HEAT;
  Temporal_filter temporal_filter = Temporal_filter::GAUSSIAN;
  Baseline baseline = Baseline::LEAST;
  Dimension dimension = Dimension::SURFACE;

  std::optional<double> alpha;
  std::optional<Programs::Length> ball_radius;
  Programs::Range<Programs::Length> sigma;
  Programs::Range<double> tau; // seconds
  bool is_cyclic = false;      // the last frame is followed by the first

  // of the preset PUBLISHED only
  std::optional<std::size_t> box_width; // frames
  std::optional<std::size_t> space_counts, time_counts;

  // which of the features are selected
  std::optional<double> threshold, relative_threshold, min_fit;
  std::optional<std::size_t> top;
  bool no_suppression = false;
};

void add_method_options(Programs::Option_group& group, Method_options& options);
void add_selection_options(Programs::Option_group& group, Method_options& options);

// To be called when all options are there.
// throws Option_error if options do not go together.
void check(const Method_options& options);

} // namespace Detect_features

#endif // DETECT_FEATURES_METHOD_OPTIONS_H
