// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_DRAWING_LEGEND_H
#define PROGRAMS_DRAWING_LEGEND_H

#include "drawing/Canvas.h"
#include "rendering/Colour.h"
#include "rendering/Colour_map.h"

#include <string>
#include <vector>

namespace Programs {

// One part of a legend: what is shown, and its colours from the least to the greatest number.
struct Legend_bar
{
  std::string name;
  std::string low, high;                          // the numbers at its ends
  const Rendering::Colour_map* colours = nullptr; // not owned
};

// The colour of text on a background.
Rendering::Srgb8 ink_on(const Rendering::Colour& background);

// Draws bars with their names and numbers, from left to right, centred in a strip of a canvas: `height` from `top` of
// the `width` that the canvas has. See `ink_on()` for the colour of the text; it becomes
// smaller if there is not enough room.
void draw_legend(Canvas& canvas, const std::vector<Legend_bar>& bars, double width, double top, double height,
                 Text_style style);

} // namespace Programs

#endif // PROGRAMS_DRAWING_LEGEND_H
