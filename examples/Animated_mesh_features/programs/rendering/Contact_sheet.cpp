// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Contact_sheet.h"

#include <algorithm>

namespace Programs::Rendering {

std::vector<Panel> panels(std::size_t number, std::size_t width, std::size_t height, double aspect)
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

} // namespace Programs::Rendering
