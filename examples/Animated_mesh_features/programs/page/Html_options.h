// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_HTML_OPTIONS_H
#define PROGRAMS_PAGE_HTML_OPTIONS_H

#include "views/View_choice.h"

#include <cstddef>
#include <optional>

namespace Programs {

// How much of a scene write_html() puts into a page.
struct Html_options
{
  // the number of vertices times frames from which on frames are left out. The default makes a page of 20 to 30 MB,
  // which a browser opens in seconds and keeps in some 200 MB of memory.
  std::size_t most_positions = 8000000;

  // how many frames must stay (if there are as many) for a page to be written nevertheless; default: with fewer, a motion
  // of a second or two is no longer recognised.
  std::size_t fewest_frames = 24;

  // keep every `frame_step`-th frame, whatever comes of it: 1 keeps all of them. Default: 0, as the two limits above tell.
  std::size_t frame_step = 0;

  // where the page is looked at from when it opens. Default: AUTO, the best of the scene's views; if it has none, the page
  // chooses.
  View_choice view;

  // the axis that points up, y (1) or z (2). Default: that of the scene's views; if it has none, the page chooses.
  std::optional<int> up_axis;
};

// Every how many frames a page has of an animation of that size; 1: all of them. To be asked before hours of computing.
// throws Option_error if the animation is too large for a page and `options.frame_step` is 0.
std::size_t html_frame_step(std::size_t number_of_vertices, std::size_t number_of_frames,
                            const Html_options& options = Html_options());

} // namespace Programs

#endif // PROGRAMS_PAGE_HTML_OPTIONS_H
