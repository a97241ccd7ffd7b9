// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_LEGEND_H
#define PROGRAMS_RENDERING_LEGEND_H

#include "rendering/Colour_map.h"
#include "rendering/draw.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace Rendering {

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

one line of a legend: what is shown, and its colours from the least to the greatest number.
*/
struct Legend_bar
{
  std::string name;                    ///< what is shown.
  std::string low;                     ///< the number at its left end.
  std::string high;                    ///< the number at its right end.
  const Colour_map* colours = nullptr; ///< not owned.
};

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

the colours of text and of other lines on a background.
*/
inline Srgb8 ink_on(const Colour& background)
{
  return luminance(background) > 0.2f ? Srgb8{{45, 48, 54}} : Srgb8{{235, 236, 240}};
}

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

a number as short as two or three significant digits allow.
*/
inline std::string short_number(double x, int digits = 3)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  std::string result = text;
  // whatever the locale of the program
  for (char& c : result)
    if (c == ',') c = '.';
  return result;
}

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

draws bars with their names and numbers beside each other, centred in a strip of an image.
\param image is drawn on
\param bars from left to right
\param top,height the strip, pixels
\param size of the text: height of its capitals, pixels
\param ink the colour of text and frames, see `ink_on()`
*/
inline void draw_legend(Srgb_image& image, const std::vector<Legend_bar>& bars, double top, double height, double size,
                        const Srgb8& ink)
{
  const double gap = 0.9 * size, between = 4 * size, bar_height = 1.1 * size;
  double text = 0;
  for (const Legend_bar& b : bars)
    text += text_width(b.name, size) + text_width(b.low, size) + text_width(b.high, size) + 3.6 * gap;
  const double n = double(bars.size()), width = double(image.width());
  const double length =
      (std::max)(2 * size, (std::min)(0.22 * width, (0.94 * width - text - (n - 1) * between) / (std::max)(1., n)));
  double x = (width - text - n * length - (n - 1) * between) / 2;
  const double base = top + (height + size) / 2; // of the text
  const auto write = [&](const std::string& t, double gap_behind) {
    draw_text(image, t, x, base, size, ink);
    x += text_width(t, size) + gap_behind;
  };
  for (const Legend_bar& b : bars) {
    write(b.name, 1.6 * gap);
    write(b.low, gap);
    const long left = std::lround(x), right = std::lround(x + length);
    const long first = std::lround(base - size / 2 - bar_height / 2),
               last = std::lround(base - size / 2 + bar_height / 2);
    for (long i = left; i < right; ++i) {
      const double t = (double(i - left) + 0.5) / double(right - left);
      const Srgb8 colour = encoded((*b.colours)(t));
      for (long j = first; j < last; ++j) blend(image, i, j, colour, 1);
    }
    x += length + gap;
    write(b.high, between);
  }
}

} // namespace Rendering
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_RENDERING_LEGEND_H
