// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PLOTS_TICKS_H
#define PROGRAMS_PLOTS_TICKS_H

#include <string>
#include <vector>

namespace Programs {

struct Tick
{
  double value;
  std::string text;
};

// Round numbers, about `wanted` of them, from `min` to `max`.
std::vector<Tick> linear_ticks(double min, double max, double wanted, bool whole_numbers = false);

// Those of a logarithmic axis: powers of ten, and as many numbers between them as there is room for. `min` is positive.
std::vector<Tick> logarithmic_ticks(double min, double max);

} // namespace Programs

#endif // PROGRAMS_PLOTS_TICKS_H
