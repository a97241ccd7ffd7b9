// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/Picture_options.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cmath>
#include <string>

using CGAL::Animated_mesh_features::Option_error;

namespace Programs {

void check_picture_options(const Picture_options& options)
{
  const auto check_side = [](std::size_t pixels) {
    if (pixels < Picture_options::smallest_side || pixels > Picture_options::largest_side)
      throw Option_error("a picture cannot be " + std::to_string(pixels) + " pixels wide or high, only " +
                         std::to_string(Picture_options::smallest_side) + " to " +
                         std::to_string(Picture_options::largest_side));
  };
  check_side(options.width);
  check_side(options.height);
  if (options.width * options.height > Picture_options::most_pixels)
    throw Option_error("a picture of " + std::to_string(options.width) + " x " + std::to_string(options.height) +
                       " pixels is too large; at most " + std::to_string(Picture_options::most_pixels) +
                       " pixels are possible");
  if (options.up_axis && (*options.up_axis < 0 || *options.up_axis > 2))
    throw Option_error("there is no axis " + std::to_string(*options.up_axis) + " that could point up");
  if (!(std::abs(options.view.elevation) < 90) || !std::isfinite(options.view.azimuth))
    throw Option_error(
        "the elevation of a picture's view must be more than -90 and less than 90 degrees, and its azimuth "
        "finite");
}

void check_picture_frames(const Picture_options& options, std::size_t number_of_frames)
{
  if (options.frames.size() > Picture_options::most_frames)
    throw Option_error("a picture cannot show " + std::to_string(options.frames.size()) + " frames; at most " +
                       std::to_string(Picture_options::most_frames));
  if (options.width * options.height < options.frames.size() * Picture_options::smallest_panel)
    throw Option_error("a picture of " + std::to_string(options.width) + " x " + std::to_string(options.height) +
                       " pixels is too small for " + std::to_string(options.frames.size()) + " frames");
  for (std::size_t f : options.frames)
    if (f >= number_of_frames)
      throw Option_error("there is no frame " + std::to_string(f) + " to be shown; frames are 0 to " +
                         std::to_string(number_of_frames - 1));
}

} // namespace Programs
