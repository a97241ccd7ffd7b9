// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_CONTACT_SHEET_H
#define PROGRAMS_RENDERING_CONTACT_SHEET_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace Rendering {

namespace internal {

// Adds frames of features, strongest first, that are at least `apart` frames from all that are chosen.
template <class FeatureRange>
void add_frames(const FeatureRange& features, std::size_t most, std::size_t apart, bool elsewhere,
                std::vector<typename FeatureRange::const_iterator>& chosen)
{
  for (auto f = features.begin(); f != features.end() && chosen.size() < most; ++f) {
    const bool is_new = std::all_of(chosen.begin(), chosen.end(), [&](const auto& g) {
      const std::size_t distance = f->frame > g->frame ? f->frame - g->frame : g->frame - f->frame;
      double squared = 0;
      for (std::size_t i = 0; i < 3; ++i)
        squared += (f->rest_position[i] - g->rest_position[i]) * (f->rest_position[i] - g->rest_position[i]);
      return distance >= apart && !(elsewhere && std::sqrt(squared) < (std::max)(f->radius(), g->radius()));
    });
    if (is_new) chosen.push_back(f);
  }
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

the frames that show most: those of the strongest features, chosen apart in time, in their order. Features of different
places come first: in a motion that repeats itself, the strongest of all are often one and the same, again and again.

\param features strongest first
\param number_of_frames of the animation
\param most how many frames at most
\returns at least one frame: the middle one, if there are no features.
*/
template <class FeatureRange>
std::vector<std::size_t> strongest_frames(const FeatureRange& features, std::size_t number_of_frames,
                                          std::size_t most = 6)
{
  std::vector<typename FeatureRange::const_iterator> chosen;
  // as far from each other as the number of frames allows, then half as far, and so on until there are enough
  const std::size_t widest = number_of_frames / (most + 1);
  for (bool elsewhere : {true, false})
    for (std::size_t apart = widest; apart > 0 && apart >= widest / 4; apart /= 2)
      internal::add_frames(features, most, apart, elsewhere, chosen);
  internal::add_frames(features, (std::min)(most, std::size_t(1)), 1, false, chosen); // of a few frames
  std::vector<std::size_t> frames;
  for (const auto& f : chosen) frames.push_back(f->frame);
  if (frames.empty()) frames.push_back(number_of_frames / 2);
  std::sort(frames.begin(), frames.end());
  return frames;
}

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

a rectangle of an image, pixels.
*/
struct Panel
{
  std::size_t left = 0;   ///< from the left
  std::size_t top = 0;    ///< from the top
  std::size_t width = 0;  ///< to the right
  std::size_t height = 0; ///< downwards
};

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

divides a rectangle into equal panels, row by row, so that pictures of a given shape are as large as possible in them.
\param number of panels
\param width,height of the rectangle
\param aspect width by height of what is to be seen in each panel
*/
inline std::vector<Panel> panels(std::size_t number, std::size_t width, std::size_t height, double aspect)
{
  std::size_t columns = 1;
  double largest = -1;
  for (std::size_t c = 1; c <= number; ++c) {
    const double w = double(width) / double(c), h = double(height) / double((number + c - 1) / c);
    const double size = (std::min)(w / aspect, h);
    if (size > largest) largest = size, columns = c;
  }
  const std::size_t rows = (number + columns - 1) / columns;
  std::vector<Panel> result;
  for (std::size_t i = 0; i < number; ++i) {
    const std::size_t column = i % columns, row = i / columns;
    Panel p;
    p.left = column * width / columns;
    p.width = (column + 1) * width / columns - p.left;
    p.top = row * height / rows;
    p.height = (row + 1) * height / rows - p.top;
    result.push_back(p);
  }
  return result;
}

} // namespace Rendering
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_RENDERING_CONTACT_SHEET_H
