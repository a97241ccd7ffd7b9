// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_DETECT_H
#define DETECT_FEATURES_DETECT_H

#include "reading/Animation.h"
#include "detect_features/Command_line.h"
#include "detect_features/Monitor.h"
#include "output/Result_files.h"

#include <CGAL/Animated_mesh_features/Detection/Detection_options.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#include <cstddef>
#include <vector>

namespace Detect_features {

struct Shown_field
{
  Field kind;
  CGAL::Animated_mesh_features::Spatio_temporal_field<FT> values;
};

// The features, and the values that were used where the command line left the choice.
struct Detection
{
  std::vector<Feature> features; // strongest first
  std::vector<Shown_field> shown_fields; // for scenes
  std::size_t number_of_minima = 0;
  std::vector<double> sigma_levels, tau_levels;   // length, seconds
  std::size_t levels_below = 0, levels_above = 0; // of them, at which no features are searched: the first and the last
  double alpha = 0;
  double deformation_noise = 0; // of the responses
  double ball_radius = 0;    // length; 0 if no balls were needed
  std::size_t box_width = 0; // frames; 0 if there is no box of given width
  CGAL::Animated_mesh_features::Triangle_weights triangle_weights;
  CGAL::Animated_mesh_features::Feature_selection selection;
};

// One line, or nothing: there are so many smoothing counts that they take long.
// throws Option_error if there are too few.
std::string counts_notice(const Sequence& sequence, const Command_line& command_line);

// Computes the deformation, writes the fields that are wanted, and finds the features. `level_memory` bytes are for the
// space levels.
// throws Option_error, Output_error, Numerical_error, Cancelled.
Detection detect(const Sequence& sequence, const Command_line& command_line, std::size_t level_memory,
                 Result_files& files, Monitor& monitor);

} // namespace Detect_features

#endif // DETECT_FEATURES_DETECT_H
