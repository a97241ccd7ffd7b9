// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_IMAGE_H
#define PROGRAMS_RENDERING_IMAGE_H

#include "rendering/Colour.h"

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace Rendering {

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

a rectangle of pixels, row by row from the top left.
*/
template <class Pixel>
class Image_of
{
public:
  /// no pixels.
  Image_of() = default;

  /// an image of one colour.
  Image_of(std::size_t width, std::size_t height, const Pixel& pixel = Pixel())
    : m_width(width)
    , m_height(height)
    , m_pixels(width * height, pixel)
  {}

  std::size_t width() const { return m_width; }   ///< pixels
  std::size_t height() const { return m_height; } ///< pixels

  /// column `x` from the left, row `y` from the top, both from 0.
  Pixel& operator()(std::size_t x, std::size_t y) { return m_pixels[y * m_width + x]; }

  /// column `x` from the left, row `y` from the top, both from 0.
  const Pixel& operator()(std::size_t x, std::size_t y) const { return m_pixels[y * m_width + x]; }

  /// all pixels, row by row.
  const std::vector<Pixel>& pixels() const { return m_pixels; }

private:
  std::size_t m_width = 0, m_height = 0;
  std::vector<Pixel> m_pixels;
};

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

an image in linear light.
*/
typedef Image_of<Colour> Image;

} // namespace Rendering
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_RENDERING_IMAGE_H
