// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_TIME_ALIGNMENT_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_TIME_ALIGNMENT_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

Which time of one animation is which of another one: a map that ascends, linear between its samples.
*/
struct Time_alignment
{
  std::vector<double> times_a; ///< seconds, strictly ascending
  std::vector<double> times_b; ///< seconds, strictly ascending, as many
  double cost = 0;             ///< from 0 for the same motion to 1
  double confidence = 0;       ///< from 0, no better than by chance, to 1

  /// of two cyclic motions: how much of a period the second one is ahead, from -0.5 to 0.5.
  std::optional<double> phase;

  /// the time of the second animation; outside of the samples the clocks run alike.
  double to_b(double time) const { return map(times_a, times_b, time); }

  /// the time of the first animation.
  double to_a(double time) const { return map(times_b, times_a, time); }

private:
  static double map(const std::vector<double>& from, const std::vector<double>& to, double time)
  {
    if (from.empty()) return time;
    if (time <= from.front()) return to.front() + time - from.front();
    if (time >= from.back()) return to.back() + time - from.back();
    const std::size_t i = std::size_t(std::upper_bound(from.begin(), from.end(), time) - from.begin());
    const double length = from[i] - from[i - 1];
    const double fraction = length > 0 ? (time - from[i - 1]) / length : 0;
    return to[i - 1] + fraction * (to[i] - to[i - 1]);
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_TIME_ALIGNMENT_H
