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

namespace Programs::Rendering {

// A rectangle of pixels, row by row from the top left.
template <class Pixel>
class Image_of
{
public:
  Image_of() = default; // no pixels

  Image_of(std::size_t width, std::size_t height, const Pixel& pixel = Pixel())
    : m_width(width)
    , m_height(height)
    , m_pixels(width * height, pixel)
  {}

  std::size_t width() const { return m_width; }
  std::size_t height() const { return m_height; }

  // column `x` from the left, row `y` from the top, both from 0
  Pixel& operator()(std::size_t x, std::size_t y) { return m_pixels[y * m_width + x]; }
  const Pixel& operator()(std::size_t x, std::size_t y) const { return m_pixels[y * m_width + x]; }

  const std::vector<Pixel>& pixels() const { return m_pixels; }

private:
  std::size_t m_width = 0, m_height = 0;
  std::vector<Pixel> m_pixels;
};

// In linear light.
typedef Image_of<Colour> Image;

// As it is stored.
typedef Image_of<Srgb8> Srgb_image;

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_IMAGE_H
