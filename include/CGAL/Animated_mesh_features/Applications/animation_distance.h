// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_DISTANCE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_DISTANCE_H

#include <CGAL/Animated_mesh_features/Applications/Activity.h>
#include <CGAL/Animated_mesh_features/Applications/align_animations.h>
#include <CGAL/Animated_mesh_features/Applications/internal/played_loop.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

What `animation_distance()` is told.
*/
struct Distance_options
{
  /// by default without places and without the least mean, with ends that count, and a slope of up to 2, see below.
  Alignment_options alignment;

  double cycle_weight = 0.1; ///< from 0 to 1: how far apart a motion that repeats itself is from one that does not

  /// from 0 to 1: how far apart a motion is from one that moves the body four times as far, if that is known of both.
  double variation_weight = 0.4;

  double duration_weight = 0.1; ///< from 0 to 1: how far apart a motion is from one that takes twice as long

  /// a pose variation that says nothing: that of noise, and of a body that stands.
  double least_variation = 0.02;

  /// The defaults: characters of different build deform at different places in the same action; what is compared is the
  /// whole of both.
  Distance_options()
  {
    alignment.without_least_mean = true;
    alignment.recurrence_weight = 1;
    alignment.recurrence_without_places = 0;
    alignment.place_weight = 0;
    alignment.bend_weight = 0;
    alignment.end_weight = 1;
    alignment.max_slope = 2;
    alignment.smoothing = 0; // of the map, which is not asked for
    alignment.surrogates = 0;
  }

  /// looks whether all numbers are in their ranges.
  /// \throw Option_error if one is not.
  void check() const
  {
    alignment.check();
    for (double w : {cycle_weight, variation_weight, duration_weight})
      if (!(w >= 0 && w <= 1))
        throw Option_error("the weights of cycles, of the variation of poses and of durations are from 0 to 1");
    if (!(least_variation > 0)) throw Option_error("the least variation of poses must be positive");
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

tells how unlike two motions are, from 0 to 1: \f$1 - (1 - c)(1 - w_z z)(1 - w_v v)(1 - w_t t)\f$ with weights \f$w\f$,
where
- \f$c\f$ is the cost of their best alignment, see `align_animations()`: how unlike the course of the deformation is,
  whatever its size;
- \f$z = |s_a - s_b| + \min(s_a, s_b) \min(|\log_2 p_a / p_b|, 1)\f$ is how unlike they are in repeating themselves, with
  their cycles' strengths \f$s\f$ and periods \f$p\f$;
- \f$v = \min(|\log_2 (\nu_a + \nu) / (\nu_b + \nu)| / 2, 1)\f$ is how unlike they are in how far the body moves, with
  their pose variations \f$\nu_a\f$ and \f$\nu_b\f$, see `pose_variation()`, and the least one \f$\nu\f$; 0 if one of
  them is not known;
- \f$t = \min(|\log_2 T_a / T_b|, 1)\f$ is how unlike their durations are, that of a loop as often as it is played
  beside the other one.

Of a loop it does not matter with which frame it begins.

Symmetric; 0 for the same motion on the same body, whatever its mesh and frame rate, up to what these change the field.

\throw Option_error if a weight is out of its range, or as `align_animations()`; Cancelled.
*/
inline double animation_distance(const Activity& a, const Activity& b,
                                 const Distance_options& options = Distance_options())
{
  options.check();
  const auto octaves = [](double x, double y) { return std::abs(std::log2(x / y)); };
  double likeness = 1 - align_animations(a, b, options.alignment).cost;
  const auto differ = [&](double weight, double by) { likeness *= 1 - weight * (std::min)(by, 1.); };
  const double s = a.cycle.strength, t = b.cycle.strength;
  double cycles = std::abs(s - t);
  if (s > 0 && t > 0) cycles += (std::min)(s, t) * (std::min)(octaves(a.cycle.period, b.cycle.period), 1.);
  differ(options.cycle_weight, cycles);
  if (a.pose_variation && b.pose_variation)
    differ(options.variation_weight,
           octaves(*a.pose_variation + options.least_variation, *b.pose_variation + options.least_variation) / 2);
  differ(options.duration_weight, octaves(a.duration() * double(internal::number_of_plays(a, b)),
                                          b.duration() * double(internal::number_of_plays(b, a))));
  return 1 - likeness;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_DISTANCE_H
