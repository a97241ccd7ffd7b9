// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ALIGN_ANIMATIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ALIGN_ANIMATIONS_H

#include <CGAL/Animated_mesh_features/Applications/Activity.h>
#include <CGAL/Animated_mesh_features/Applications/Alignment_options.h>
#include <CGAL/Animated_mesh_features/Applications/Time_alignment.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Activity_cost.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Time_refinement.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Time_warping.h>
#include <CGAL/Animated_mesh_features/Applications/internal/cyclic_phase.h>
#include <CGAL/Animated_mesh_features/Applications/internal/surrogates.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

finds the monotone map of time by which two motions are most alike: dynamic time warping (Sakoe and Chiba
\cgalCite{sakoe1978}) of their activities, with a limited slope and, where one of them begins or ends in the middle of
the other, open ends. A smooth map is then made of it, to a fraction of a sample, as curves are registered (Ramsay and Li
\cgalCite{ramsay1998}): the one by which the activities are most alike, less what its bends cost. Where nothing moves and
no map is better than another, it bends least between what moves before and after; beginnings, and ends, of two animations
that are both still belong together, unless one is still for longer than the slope allows.

The confidence is \f$\max(1 - (c / \bar c)^2, 0)\f$, where \f$\bar c\f$ is the mean cost of surrogates, the second
animation backwards and with its pieces of a third of a second in another order, which have the same activity at other
times: 0 if the alignment costs no less than those, as it does for motions that have nothing to do with each other, near
1 for the same motion.

`O(S T_a T_b (1 + surrogates))` time, `5 T_a T_b` bytes, for slope `S` and `T` samples.

\param a, b the activities, with the same time between samples and the same lags.
\param options weights and limits.
\throw Option_error if an option is out of its range, or the activities do not go together; Cancelled if it is called in a
  task of a `Task_loop`, whose visitor is asked every tenth of a second, and has had enough.
*/
inline Time_alignment align_animations(const Activity& a, const Activity& b,
                                       const Alignment_options& options = Alignment_options())
{
  options.check();
  const internal::Activity_cost cost(a, b, options);
  const double bend_cost = options.bend_weight * cost.mean_norm();
  const internal::Time_warping warping(a.samples, b.samples, cost, options.max_slope, options.end_weight, bend_cost);
  Time_alignment result;
  result.cost = cost.relative(warping.cost());
  const auto add = [&](double sample_of_a, double sample_of_b) {
    result.times_a.push_back(sample_of_a * a.sample_duration);
    result.times_b.push_back(sample_of_b * a.sample_duration);
  };
  if (options.smoothing > 0) {
    const internal::Time_refinement map(cost, warping.path(), options.smoothing / a.sample_duration, options.max_slope);
    for (std::size_t k = 0; k < map.size(); ++k) add(map.a(k), map.b(k));
  } else {
    for (const auto& [i, j] : warping.path()) add(double(i), double(j));
  }
  if (options.surrogates > 0) {
    std::vector<double> others;
    for (std::size_t k = 0; k < options.surrogates; ++k) {
      const std::vector<std::size_t> order = internal::surrogate_order(b.samples, b.sample_duration, k);
      const internal::Time_warping other(
          a.samples, b.samples, [&](std::size_t i, std::size_t j) { return cost(i, order[j]); }, options.max_slope,
          options.end_weight, bend_cost);
      others.push_back(cost.relative(other.cost()));
    }
    double chance = 0;
    for (double c : others) chance += c / double(others.size());
    const double ratio = chance > 0 ? result.cost / chance : 1;
    result.confidence = (std::max)(1 - ratio * ratio, 0.);
  }
  if (a.cycle.period > 0 && b.cycle.period > 0) result.phase = internal::cyclic_phase(a, b, cost);
  return result;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ALIGN_ANIMATIONS_H
