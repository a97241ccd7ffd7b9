// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_HTML_OPTIONS_H
#define PROGRAMS_PAGE_HTML_OPTIONS_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

How much of a scene `write_html()` puts into a page.
*/
struct Html_options
{
  /// the number of vertices times frames from which on frames are left out. The default makes a page of 20 to 30 MB,
  /// which a browser opens in seconds and keeps in some 200 MB of memory.
  std::size_t most_positions = 8000000;

  /// how many frames must stay (if there are as many) for a page to be written nevertheless; default: with fewer, a
  /// motion of a second or two is no longer recognised.
  std::size_t fewest_frames = 24;

  /// keep every `frame_step`-th frame, whatever comes of it: 1 keeps all of them. Default: 0, as the two limits above
  /// tell.
  std::size_t frame_step = 0;
};

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

What `write_html()` did.
*/
struct Html_report
{
  std::size_t frame_step = 1; ///< every so many frames are in the page
  double largest_error = 0;   ///< no vertex is farther from where it was, in bounding-box diagonals of the rest shape
};

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

every how many frames a page has of an animation of that size; 1: all of them. To be asked before hours of computing.

\throw Option_error if the animation is too large for a page and `options.frame_step` is 0.
*/
inline std::size_t html_frame_step(std::size_t number_of_vertices, std::size_t number_of_frames,
                                   const Html_options& options = Html_options())
{
  if (options.frame_step > 0) return options.frame_step;
  const std::size_t n = (std::max)(number_of_vertices, std::size_t(1));
  const std::size_t most_frames = options.most_positions / n;
  if (number_of_frames <= most_frames) return 1;
  if (most_frames < (std::min)(options.fewest_frames, number_of_frames))
    throw Option_error("the animation is too large for a page: " + std::to_string(number_of_vertices) +
                       " vertices leave room for " + std::to_string(most_frames) + " of its " +
                       std::to_string(number_of_frames) + " frames, fewer than " +
                       std::to_string(options.fewest_frames) + "; say how many frames it shall have nevertheless");
  return (number_of_frames + most_frames - 1) / most_frames;
}

namespace internal {

// Every `step`-th frame, and the last one.
inline std::vector<std::size_t> kept_frames(std::size_t number_of_frames, std::size_t step)
{
  std::vector<std::size_t> frames;
  for (std::size_t f = 0; f < number_of_frames; f += step) frames.push_back(f);
  if (number_of_frames > 0 && frames.back() + 1 != number_of_frames) frames.push_back(number_of_frames - 1);
  return frames;
}

} // namespace internal

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PAGE_HTML_OPTIONS_H
