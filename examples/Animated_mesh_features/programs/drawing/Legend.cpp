// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "drawing/Legend.h"

#include <algorithm>
#include <cmath>

namespace Programs {

Rendering::Srgb8 ink_on(const Rendering::Colour& background)
{
  return Rendering::luminance(background) > 0.2f ? Rendering::Srgb8{{45, 48, 54}} : Rendering::Srgb8{{235, 236, 240}};
}

void draw_legend(Canvas& canvas, const std::vector<Legend_bar>& bars, double width, double top, double height,
                 Text_style style)
{
  const double n = double(bars.size());
  const auto text_width = [&] {
    double result = n * 3.6 * 0.9 * capital_height * style.size; // the gaps
    for (const Legend_bar& b : bars)
      for (const std::string* t : {&b.name, &b.low, &b.high}) result += canvas.text_width(*t, style);
    return result;
  };
  const double most = 0.94 * width, least = text_width() + (n * 2 + (n - 1) * 4) * capital_height * style.size;
  if (least > most) style.size *= most / least;
  const double capitals = capital_height * style.size;
  const double gap = 0.9 * capitals, between = 4 * capitals, bar_height = 1.1 * capitals, text = text_width();
  const double length =
      (std::max)(2 * capitals, (std::min)(0.22 * width, (most - text - (n - 1) * between) / (std::max)(1., n)));
  double x = (width - text - n * length - (n - 1) * between) / 2;
  const double base = top + (height + capitals) / 2; // of the text
  const auto write = [&](const std::string& t, double following_gap) {
    canvas.text(x, base, t, style);
    x += canvas.text_width(t, style) + following_gap;
  };
  for (const Legend_bar& b : bars) {
    write(b.name, 1.6 * gap);
    write(b.low, gap);
    // on whole pixels, for sharp edges
    const double left = std::round(x), first = std::round(base - (capitals + bar_height) / 2);
    canvas.colour_bar(left, first, std::round(x + length) - left,
                      std::round(base - (capitals - bar_height) / 2) - first, *b.colours);
    x += length + gap;
    write(b.high, between);
  }
}

} // namespace Programs
