// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PICTURES_PICTURE_OPTIONS_H
#define PROGRAMS_PICTURES_PICTURE_OPTIONS_H

#include "views/View_choice.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace Programs {

// What a picture of a scene shows, and from where.
struct Picture_options
{
  // pixels; each from `smallest_side` to `largest_side`, and `most_pixels` in all
  std::size_t width = 1600, height = 1000;

  // The frames, from 0, each in a panel of its own. None: those of the strongest features, at most 6, chosen apart in
  // time.
  std::vector<std::size_t> frames;

  // The axis that points up: 0, 1, 2 for x, y, z. None: y or z, on which the body stands.
  std::optional<int> up_axis;

  // Where the camera is. AUTO: where it sees most of the features, see scene_views(); in panels of frames of which that
  // view hides too much, elsewhere.
  View_choice view;

  std::array<std::uint8_t, 3> background = {{255, 255, 255}}; // sRGB, 8 bits a channel

  static constexpr std::size_t smallest_side = 64;                 // of width and height (pixels)
  static constexpr std::size_t largest_side = 16384;               // of width and height (pixels)
  static constexpr std::size_t most_pixels = std::size_t(1) << 25; // which take some 150 bytes each
  static constexpr std::size_t most_frames = 100;                  // panels
  static constexpr std::size_t smallest_panel = 48 * 48;           // pixels for a panel
};

// Checks what can be known before there is a scene.
// throws Option_error if an option has a value that makes no sense for any scene.
void check_picture_options(const Picture_options& options);

// Checks what can be known when the number of frames is.
// throws Option_error if a frame to be shown is not there, or there are too many of them for the picture.
void check_picture_frames(const Picture_options& options, std::size_t number_of_frames);

} // namespace Programs

#endif // PROGRAMS_PICTURES_PICTURE_OPTIONS_H
