// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/Html_options.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <string>

namespace Programs {

Html_sampling html_sampling(std::size_t number_of_vertices, std::size_t number_of_frames, const Html_options& options)
{
  if (options.frame_step > 0) return {number_of_vertices, options.frame_step};
  Html_sampling result{number_of_vertices, 1};
  const std::size_t frames = (std::max)(number_of_frames, std::size_t(1));
  if (number_of_vertices > options.most_positions / frames)
    result.vertices = (std::min)(number_of_vertices, (std::max)(options.most_positions / frames, options.fewest_vertices));
  const std::size_t most_frames = options.most_positions / (std::max)(result.vertices, std::size_t(1));
  if (number_of_frames <= most_frames) return result;
  if (most_frames < (std::min)(options.fewest_frames, number_of_frames))
    throw CGAL::Animated_mesh_features::Option_error(
        "the animation is too large for a page: " + std::to_string(result.vertices) + " vertices leave room for " +
        std::to_string(most_frames) + " of its " + std::to_string(number_of_frames) + " frames, fewer than " +
        std::to_string(options.fewest_frames) + "; say how many frames it shall have nevertheless");
  result.frame_step = (number_of_frames + most_frames - 1) / most_frames;
  return result;
}

Html_options half_of_page(Html_options options)
{
  options.most_positions /= 2;
  return options;
}

} // namespace Programs
