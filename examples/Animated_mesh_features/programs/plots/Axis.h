// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PLOTS_AXIS_H
#define PROGRAMS_PLOTS_AXIS_H

#include "drawing/Canvas.h"
#include "plots/ticks.h"

#include <string>
#include <vector>

namespace Programs {

// Values to places on a canvas.
struct Axis
{
  double min, max;   // of the values; both positive if the axis is logarithmic
  double begin, end; // of the places
  bool is_logarithmic = false;

  double operator()(double x) const;
};

// The looks of a plot.
struct Plot_style
{
  Rendering::Srgb8 ink = {{31, 35, 40}}, dim = {{89, 99, 110}}, grid = {{209, 217, 224}};
  double text_size = 13, heading_size = 20;

  Text_style text(double anchor = 0) const;
  Text_style dim_text(double anchor = 0) const;
  Text_style heading() const;
};

// A horizontal axis at the height `y`, with its name below.
void draw_x_axis(Canvas& canvas, const Axis& axis, const std::vector<Tick>& ticks, double y, const std::string& name,
                 const Plot_style& style);

// Lines through the plot, from `begin` to `end`, with their numbers and the name of the axis at the left.
void draw_y_axis(Canvas& canvas, const Axis& axis, const std::vector<Tick>& ticks, double begin, double end,
                 const std::string& name, const Plot_style& style);

} // namespace Programs

#endif // PROGRAMS_PLOTS_AXIS_H
