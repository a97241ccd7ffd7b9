// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_COMMAND_LINE_H
#define DETECT_FEATURES_COMMAND_LINE_H

#include "detect_features/Choices.h"

#include "pictures/Picture_options.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace Detect_features {

// A length of the mesh, or a fraction of the bounding-box diagonal of the rest shape.
struct Length
{
  double value = 0;
  bool is_percentage = false;

  double on(double diagonal) const { return is_percentage ? value / 100 * diagonal : value; }
};

template <class T>
struct Range
{
  std::string text; // as it was given, or empty
  std::optional<T> min, max;
};

// "-" is the standard output.
template <class Kind>
struct Requested_file
{
  Kind kind;
  std::string path;
};

// What was asked for, complete and consistent as far as can be told without the data.
struct Command_line
{
  bool help = false, version = false;

  std::vector<std::string> inputs;
  std::optional<double> frames_per_second;
  std::string clip; // empty: the first
  std::optional<std::size_t> clip_frames;
  bool there_and_back = false;
  std::string faces_dataset;
  bool triangulate = false;

  // either a file, or a frame, or the average of all frames
  std::string rest = "frame:0"; // as it was given
  std::string rest_file;
  std::optional<std::size_t> rest_frame;
  bool rescale_rest = false;

  // of the preset, unless chosen
  Preset preset = Preset::CALIBRATED;
  Strain strain = Strain::HENCKY;
  Curvature curvature = Curvature::DENSITY;
  Balls balls = Balls::HEAT;
  Spatial_filter spatial_filter = Spatial_filter::HEAT;
  Temporal_filter temporal_filter = Temporal_filter::GAUSSIAN;

  std::optional<std::size_t> box_width;
  std::optional<std::size_t> space_counts, time_counts;
  std::optional<Length> ball_radius;
  std::optional<double> alpha;
  Range<Length> sigma;
  Range<double> tau;

  std::optional<double> threshold, absolute_threshold;
  bool no_suppression = false;

  std::vector<Requested_file<Format>> outputs;
  std::vector<Requested_file<Field>> fields;
  std::string vertex_map; // empty: none
  std::vector<Requested_file<Scene_format>> scenes;
  std::size_t html_frame_step = 0; // 0: as the size of the page allows
  Programs::Picture_options picture;

  std::size_t threads = 0;           // 0: all
  std::optional<std::size_t> memory; // bytes
  std::string scratch_directory;
  bool quiet = false, verbose = false;

  bool is_written(Field field) const;
  // whether a scene shows it, so that it is kept until the features are known
  bool is_shown(Field field) const;
  // how many fields there are at a time besides those of every detection
  std::size_t extra_fields() const;
};

// throws Option_error, with a message for the user.
Command_line parse_command_line(int argc, const char* const* argv);

std::string full_usage();

} // namespace Detect_features

#endif // DETECT_FEATURES_COMMAND_LINE_H
