// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_DRAW_H
#define PROGRAMS_RENDERING_DRAW_H

#include "rendering/Colour.h"
#include "rendering/Image.h"
#include "rendering/Stroke_font.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace Rendering {

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

an image as it is stored.
*/
typedef Image_of<Srgb8> Srgb_image;

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

lays a colour over a pixel, if there is such a pixel. Blended as it is encoded: thin letters keep their weight.
*/
inline void blend(Srgb_image& image, long x, long y, const Srgb8& colour, double opacity)
{
  if (x < 0 || y < 0 || x >= long(image.width()) || y >= long(image.height())) return;
  Srgb8& p = image(std::size_t(x), std::size_t(y));
  for (std::size_t i = 0; i < 3; ++i)
    p[i] = std::uint8_t(double(p[i]) + opacity * (double(colour[i]) - double(p[i])) + 0.5);
}

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

draws strokes with a round pen of the given width (pixels), with smooth edges.
*/
inline void draw_strokes(Srgb_image& image, const std::vector<Stroke_font::Stroke>& strokes, double pen,
                         const Srgb8& colour)
{
  Eigen::Vector2d low(double(image.width()), double(image.height())), high(0, 0);
  for (const auto& s : strokes)
    for (const Eigen::Vector2d& p : s) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double reach = pen / 2 + 1;
  const long first_x = (std::max)(0l, long(low[0] - reach)), first_y = (std::max)(0l, long(low[1] - reach));
  const long last_x = (std::min)(long(image.width()), long(high[0] + reach) + 1);
  const long last_y = (std::min)(long(image.height()), long(high[1] + reach) + 1);
  for (long y = first_y; y < last_y; ++y)
    for (long x = first_x; x < last_x; ++x) {
      const Eigen::Vector2d q(double(x) + 0.5, double(y) + 0.5);
      double distance = reach;
      for (const auto& s : strokes)
        for (std::size_t i = 1; i < s.size(); ++i) {
          const Eigen::Vector2d along = s[i] - s[i - 1];
          const double length = along.squaredNorm();
          const double t = length > 0 ? (std::min)(1., (std::max)(0., (q - s[i - 1]).dot(along) / length)) : 0;
          distance = (std::min)(distance, (q - s[i - 1] - t * along).norm());
        }
      const double cover = (std::min)(1., (std::max)(0., pen / 2 + 0.5 - distance));
      if (cover > 0) blend(image, x, y, colour, cover);
    }
}

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

the width of a text whose capitals are `size` pixels high.
*/
inline double text_width(const std::string& text, double size)
{
  return Stroke_font::width(Stroke_font::characters(text)) * size / Stroke_font::capital_height;
}

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

draws a text whose capitals are `size` pixels high, from `x` to the right, on the base line `y`.
*/
inline void draw_text(Srgb_image& image, const std::string& text, double x, double y, double size, const Srgb8& colour)
{
  const double scale = size / Stroke_font::capital_height;
  for (char32_t c : Stroke_font::characters(text)) {
    if (c != U' ') {
      std::vector<Stroke_font::Stroke> strokes = Stroke_font::glyph(c).strokes;
      for (auto& s : strokes)
        for (Eigen::Vector2d& p : s) p = Eigen::Vector2d(x + scale * p[0], y - scale * p[1]);
      draw_strokes(image, strokes, Stroke_font::pen_width * scale, colour);
    }
    x += scale * Stroke_font::advance(c);
  }
}

} // namespace Rendering
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_RENDERING_DRAW_H
