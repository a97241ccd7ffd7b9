// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_SEARCHED_SCALES_H
#define DETECT_FEATURES_SEARCHED_SCALES_H

#include <cstddef>
#include <vector>

namespace Detect_features {

// The levels of the scale space.
struct Searched_scales
{
  std::vector<double> sigma_levels, tau_levels; // length, seconds

  // how many of them, the first and the last, are there to be compared with: no features are searched at them
  std::size_t levels_below = 0, levels_above = 0;
};

} // namespace Detect_features

#endif // DETECT_FEATURES_SEARCHED_SCALES_H
