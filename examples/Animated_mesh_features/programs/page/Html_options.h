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
  // the number of vertices times frames from which on vertices and frames are left out. The default makes a page of 15 to
  // 35 MB, which a browser opens in seconds and keeps in some 200 MB of memory.
  std::size_t most_positions = 6500000;

  // how many vertices stay (if there are as many) before frames are left out, too: on a screen, a surface of so many looks
  // like one of more, and what happens within two frames is not seen any more if one is missing.
  std::size_t fewest_vertices = 20000;

  // how many frames must stay (if there are as many) for a page to be written nevertheless; default: with fewer, a motion
  // of a second or two is no longer recognised.
  std::size_t fewest_frames = 24;

  // keep all vertices and every `frame_step`-th frame, whatever comes of it: 1 keeps all of them. Default: 0, as the limits
  // above tell.
  std::size_t frame_step = 0;

  // where the page is looked at from when it opens. Default: AUTO, the best of the scene's views; if it has none, the page
  // chooses.
  View_choice view;

  // the axis that points up, y (1) or z (2). Default: that of the scene's views; if it has none, the page chooses.
  std::optional<int> up_axis;
};

// What a page has of an animation.
struct Html_sampling
{
  std::size_t vertices = 0;   // at most; all, if the animation has not more
  std::size_t frame_step = 1; // every so many frames; 1: all of them
};

// What a page has of an animation of that size. To be asked before hours of computing.
// throws Option_error if the animation is too large for a page and `options.frame_step` is 0.
Html_sampling html_sampling(std::size_t number_of_vertices, std::size_t number_of_frames,
                            const Html_options& options = Html_options());

// What a page of two animations has room for, of each.
Html_options half_of_page(Html_options options);

} // namespace Programs

#endif // PROGRAMS_PAGE_HTML_OPTIONS_H
