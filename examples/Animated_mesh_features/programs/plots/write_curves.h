// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PLOTS_WRITE_CURVES_H
#define PROGRAMS_PLOTS_WRITE_CURVES_H

#include "drawing/Drawing_format.h"

#include <ostream>
#include <string>
#include <vector>

namespace Programs {

// Points that are joined by lines, from left to right.
struct Curve
{
  std::string name;
  std::vector<double> x, y;
  bool is_chance = false; // drawn thinly, in the colour of the curve before it
};

// Shares, from 0 to 1, or whatever else is not negative, over something.
struct Curves
{
  std::string title, subtitle, x_name, y_name;
  std::vector<Curve> curves;
  double y_max = 1;
};

// Draws curves with their axes and a key.
// throws Output_error if cairo cannot draw it, bad_alloc; errors of the stream are left in its state.
void write_curves(std::ostream& os, const Curves& curves, Drawing_format format);

} // namespace Programs

#endif // PROGRAMS_PLOTS_WRITE_CURVES_H
