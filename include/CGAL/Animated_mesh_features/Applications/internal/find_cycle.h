// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_FIND_CYCLE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_FIND_CYCLE_H

#include <CGAL/Animated_mesh_features/Applications/Activity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A motion repeats itself after the first lag at which it is about as much like itself as at any lag but 0. `profile`:
// the mean squared difference at each lag, relative to that of any two times, which is 1; `step` seconds between lags.
// `least` is the difference at larger lags: 1, as nothing is known of them, or 0 of a loop, which is the same again after
// its whole duration.
inline Cycle find_cycle(const std::vector<double>& profile, double step, double least)
{
  const double most = 0.35;                     // of the difference at a period
  const double rise = 0.35;                     // from the period to what is before it
  const double tolerance = 0.08;                // of what counts as about as much
  const std::size_t n = profile.size() * 3 / 4; // larger lags compare too few times
  const auto is_minimum = [&](std::size_t k, double highest) {
    return profile[k] <= profile[k - 1] && profile[k] <= profile[k + 1] && profile[k] < most &&
           highest - profile[k] >= rise;
  };
  double highest = 0, best = least;
  for (std::size_t k = 1; k < n; ++k) {
    if (is_minimum(k, highest)) best = (std::min)(best, profile[k]);
    highest = (std::max)(highest, profile[k]);
  }
  highest = 0;
  for (std::size_t k = 1; k < n; ++k) {
    if (is_minimum(k, highest) && profile[k] <= best + tolerance) {
      const double before = profile[k - 1], after = profile[k + 1], bend = before - 2 * profile[k] + after;
      const double shift = bend > 0 ? (before - after) / (2 * bend) : 0;
      return {(double(k) + shift) * step, 1 - profile[k]};
    }
    highest = (std::max)(highest, profile[k]);
  }
  return Cycle();
}

// A loop is a whole number of cycles; the one that is found, or else one.
inline Cycle cycle_of_loop(const Cycle& found, double duration)
{
  if (!(found.period > 0)) return {duration, 1};
  return {duration / (std::max)(std::round(duration / found.period), 1.), found.strength};
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_FIND_CYCLE_H
