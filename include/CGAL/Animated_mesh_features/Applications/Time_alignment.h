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
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

Which time of one animation is which of another one: a map that ascends, linear between its samples.

Of a loop, whose first frame follows the last one, the samples are those of one way around it, or of several, and begin
anywhere in it: their times go on past its end.
*/
struct Time_alignment
{
  std::vector<double> times_a; ///< seconds, strictly ascending
  std::vector<double> times_b; ///< seconds, strictly ascending, as many
  double cost = 0;             ///< from 0 for the same motion to 1
  double confidence = 0;       ///< from 0, no better than by chance, to 1

  double period_a = 0; ///< seconds, of the first animation if it is a loop; else 0
  double period_b = 0; ///< the same of the second one

  /// of two cyclic motions: how much of a period the second one is ahead, from -0.5 to 0.5; of two loops, of the loop that
  /// is played once.
  std::optional<double> phase;

  /// the time of the second animation, of a loop from 0 to before its period; outside of the samples of what ends the
  /// clocks run alike.
  double to_b(double time) const { return map(times_a, period_a, times_b, period_b, time); }

  /// the time of the first animation.
  double to_a(double time) const { return map(times_b, period_b, times_a, period_a, time); }

  /// how long before, or if negative after, `time_b` of the second animation that is which belongs to a time of the first
  /// one; if one of them alone is a loop, in the loop; half of a period at most.
  double lateness(double time_a, double time_b) const
  {
    if (!(period_b > 0) && period_a > 0) return std::remainder(time_a - to_a(time_b), period_a);
    const double late = time_b - to_b(time_a);
    return period_b > 0 ? std::remainder(late, period_b) : late;
  }

  /// the same map of the second animation to the first one.
  Time_alignment reversed() const
  {
    Time_alignment result = *this;
    result.times_a.swap(result.times_b);
    std::swap(result.period_a, result.period_b);
    if (phase) result.phase = -*phase;
    return result;
  }

private:
  // A time of a loop: from `first` to before a period later.
  static double within(double time, double first, double period)
  {
    if (!(period > 0)) return time;
    const double after = std::fmod(time - first, period);
    return first + (after < 0 ? after + period : after);
  }

  static double map(const std::vector<double>& from, double period_from, const std::vector<double>& to,
                    double period_to, double time)
  {
    if (from.empty()) return time;
    return within(map(from, to, within(time, from.front(), period_from)), 0, period_to);
  }

  static double map(const std::vector<double>& from, const std::vector<double>& to, double time)
  {
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
