// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "simplify_animation/wanted_levels.h"

#include <CGAL/Animated_mesh_features/Applications/Simplification_limits.h>

#include <algorithm>
#include <cmath>

namespace AMF = CGAL::Animated_mesh_features;

namespace Simplify_animation {

std::vector<std::size_t> wanted_levels(const Command_line& o, const AMF::Rest_shape& rest)
{
  if (!o.vertices.empty()) return o.vertices;
  std::vector<std::size_t> counts;
  const AMF::Simplification_limits limits(rest);
  for (double ratio : o.ratios) counts.push_back(std::size_t(std::llround(ratio * double(limits.used))));
  if (o.error)
    for (std::size_t n = limits.used; n > limits.least; n = (std::min)(n - 1, std::size_t(.9 * double(n))))
      counts.push_back(n);
  if (counts.empty()) counts.push_back(limits.used);
  return counts;
}

void keep_coarsest_within(double error, double diagonal, const Measurement& measure, AMF::Simplified_animation& result)
{
  std::size_t low = 0, high = result.levels.size(); // low: all vertices, no error
  while (low + 1 < high) {
    const std::size_t middle = (low + high) / 2;
    const double worst = 100 / diagonal * AMF::worst_frame(measure(result.levels[middle]).frames).mean();
    (worst <= error ? low : high) = middle;
  }
  result.levels = {result.levels[low]};
}

} // namespace Simplify_animation
