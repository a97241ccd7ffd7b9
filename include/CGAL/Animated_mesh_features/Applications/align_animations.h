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
#include <CGAL/Animated_mesh_features/Applications/internal/Warped_pair.h>
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

Of a loop, see `Activity::is_cyclic`, the first sample follows the last one. Two loops: the best closed way around both,
from whatever samples they begin, and the phase, of the whole loop, by which the second one is ahead. A loop and an
animation that ends: the loop from the sample from which it is most alike. The shorter one, if it is a loop, is played as
often as makes the durations most alike. If the slope does not suffice for a closed way, which it does from 2 on, the cost
is 1 and the map even.

`O(S T_a T_b (1 + surrogates))` time, `5 T_a T_b` bytes, for slope `S` and `T` samples; for loops up to 150 times as much
time: so many warpings are tried, from pairs of samples at every 32nd part of either, and nearer to the best.

\param a, b the activities, with the same time between samples and the same lags.
\param options weights and limits.
\throw Option_error if an option is out of its range, or the activities do not go together; Cancelled if it is called in a
  task of a `Task_loop`, whose visitor is asked every tenth of a second, and has had enough.
*/
inline Time_alignment align_animations(const Activity& a, const Activity& b,
                                       const Alignment_options& options = Alignment_options())
{
  options.check();
  if (a.is_cyclic && !b.is_cyclic) return align_animations(b, a, options).reversed();
  const internal::Warped_pair pair(a, b, options);
  const internal::Warped_pair::Way way = pair.way([](std::size_t j) { return j; });
  Time_alignment result;
  result.cost = way.cost;
  result.period_a = a.is_cyclic ? a.duration() : 0;
  result.period_b = b.is_cyclic ? b.duration() : 0;
  const auto add = [&](double sample_of_a, double sample_of_b) {
    result.times_a.push_back(sample_of_a * a.sample_duration);
    result.times_b.push_back(sample_of_b * a.sample_duration);
  };
  if (options.smoothing > 0) {
    for (const auto& [i, j] : pair.smooth(way)) add(i, j);
  } else {
    for (const auto& [i, j] : way.path) add(double(way.first.first + i), double(way.first.second + j));
  }
  if (options.surrogates > 0) {
    double chance = 0;
    for (std::size_t k = 0; k < options.surrogates; ++k) {
      const std::vector<std::size_t> order = internal::surrogate_order(b.samples, b.sample_duration, k);
      chance += pair.way([&](std::size_t j) { return order[j]; }).cost / double(options.surrogates);
    }
    const double ratio = chance > 0 ? result.cost / chance : 1;
    result.confidence = (std::max)(1 - ratio * ratio, 0.);
  }
  if (a.is_cyclic)
    result.phase = internal::phase_of_loops(result);
  else if (a.cycle.period > 0 && b.cycle.period > 0)
    result.phase = internal::cyclic_phase(a, b, internal::Activity_cost(a, b, options));
  return result;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ALIGN_ANIMATIONS_H
