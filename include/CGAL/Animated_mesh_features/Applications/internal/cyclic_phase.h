// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_CYCLIC_PHASE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_CYCLIC_PHASE_H

#include <CGAL/Animated_mesh_features/Applications/Activity.h>
#include <CGAL/Animated_mesh_features/Applications/Time_alignment.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Activity_cost.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// How far the second of two cyclic motions is ahead, as a share of a period: the shift at which samples of the same
// phase are most alike, refined by a parabola. O(T_a + 64 T_a) comparisons.
inline double cyclic_phase(const Activity& a, const Activity& b, const Activity_cost& cost)
{
  const std::size_t shifts = 64;
  std::vector<double> sums(shifts, 0);
  const double periods_of_b = std::floor(b.duration() / b.cycle.period);
  for (std::size_t k = 0; k < shifts; ++k) {
    cancellation_point();
    for (std::size_t i = 0; i < a.samples; ++i) {
      const double phase = double(i) * a.sample_duration / a.cycle.period + double(k) / double(shifts);
      // of all samples of b at this phase the one in the same cycle, or the last one
      const double cycle = (std::min)(std::floor(phase), (std::max)(periods_of_b - 1, 0.));
      const double at = (cycle + phase - std::floor(phase)) * b.cycle.period / b.sample_duration;
      sums[k] += cost(i, (std::min)(std::size_t(std::lround(at)), b.samples - 1));
    }
  }
  const std::size_t best = std::size_t(std::min_element(sums.begin(), sums.end()) - sums.begin());
  const double before = sums[(best + shifts - 1) % shifts], after = sums[(best + 1) % shifts];
  const double bend = before - 2 * sums[best] + after;
  const double shift = bend > 0 ? (before - after) / (2 * bend) : 0;
  const double phase = -(double(best) + shift) / double(shifts);
  return phase - std::round(phase);
}

// The same of two loops by their map: how far, in the mean, the second one is ahead, as a share of the loop.
inline double phase_of_loops(const Time_alignment& alignment)
{
  const std::vector<double>&a = alignment.times_a, &b = alignment.times_b;
  if (a.size() < 2) return 0;
  const double length_a = a.back() - a.front(), length_b = b.back() - b.front();
  const auto ahead = [&](std::size_t k) { return a[k] / length_a - b[k] / length_b; };
  double sum = 0;
  for (std::size_t k = 1; k < a.size(); ++k)
    sum += (ahead(k - 1) + ahead(k)) / 2 * ((a[k] - a[k - 1]) / length_a + (b[k] - b[k - 1]) / length_b) / 2;
  return sum - std::round(sum);
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_CYCLIC_PHASE_H
