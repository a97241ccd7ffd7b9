// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plots/Axis.h"

#include <cmath>

namespace Programs {

double Axis::operator()(double x) const
{
  const double u = is_logarithmic ? std::log(x / min) / std::log(max / min) : (x - min) / (max - min);
  return begin + u * (end - begin);
}

Text_style Plot_style::text(double anchor) const
{
  Text_style style;
  style.size = text_size;
  style.colour = ink;
  style.anchor = anchor;
  return style;
}

Text_style Plot_style::dim_text(double anchor) const
{
  Text_style style = text(anchor);
  style.colour = dim;
  return style;
}

Text_style Plot_style::heading() const
{
  Text_style style = text();
  style.size = heading_size;
  style.is_bold = true;
  return style;
}

void draw_x_axis(Canvas& canvas, const Axis& axis, const std::vector<Tick>& ticks, double y, const std::string& name,
                 const Plot_style& style)
{
  const double tick_length = 5;
  const Pen pen = {style.dim, 1};
  canvas.line(axis.begin, y, axis.end, y, pen);
  for (const Tick& t : ticks) {
    canvas.line(axis(t.value), y, axis(t.value), y + tick_length, pen);
    canvas.text(axis(t.value), y + 20, t.text, style.dim_text(0.5));
  }
  canvas.text((axis.begin + axis.end) / 2, y + 42, name, style.text(0.5));
}

void draw_y_axis(Canvas& canvas, const Axis& axis, const std::vector<Tick>& ticks, double begin, double end,
                 const std::string& name, const Plot_style& style)
{
  const double to_middle = capital_height * style.text_size / 2; // of a line of text, from its base line
  for (const Tick& t : ticks) {
    if (t.value > axis.min) canvas.line(begin, axis(t.value), end, axis(t.value), {style.grid, 1});
    canvas.text(begin - 8, axis(t.value) + to_middle, t.text, style.dim_text(1));
  }
  Text_style upward = style.text(0.5);
  upward.is_upward = true;
  canvas.text(begin - 52, (axis.begin + axis.end) / 2, name, upward);
}

} // namespace Programs
