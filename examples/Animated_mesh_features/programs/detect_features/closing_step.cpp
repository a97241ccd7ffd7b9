// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/closing_step.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Detect_features {

double closing_step(const Programs::Values& field)
{
  const std::size_t frames = field.number_of_frames();
  std::vector<double> changes(frames, 0); // from each frame to the next, from the last to the first
  for (std::size_t v = 0; v < field.number_of_rows(); ++v) {
    const Programs::FT* const row = field.row(v);
    for (std::size_t f = 0; f + 1 < frames; ++f) changes[f] += std::abs(row[f + 1] - row[f]);
    changes.back() += std::abs(row[0] - row[frames - 1]);
  }
  const double largest = *std::max_element(changes.begin(), changes.end() - 1);
  return largest > 0 ? changes.back() / largest : 0;
}

} // namespace Detect_features
