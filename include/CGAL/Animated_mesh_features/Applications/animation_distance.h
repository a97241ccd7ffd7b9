// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_DISTANCE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_DISTANCE_H

#include <CGAL/Animated_mesh_features/Applications/Activity.h>
#include <CGAL/Animated_mesh_features/Applications/align_animations.h>
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
    alignment.surrogates = 0;
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

tells how unlike two motions are, from 0 to 1: \f$1 - (1 - c)(1 - w\,z)\f$, where \f$c\f$ is the cost of their best
alignment, see `align_animations()`, \f$w\f$ the weight of cycles, and \f$z\f$ how unlike they are in repeating
themselves:
\f$|s_a - s_b| + \min(s_a, s_b) \min(|\log_2 p_a / p_b|, 1)\f$ with their cycles' strengths \f$s\f$ and periods \f$p\f$.

Symmetric; 0 for the same motion on the same body, whatever its mesh and frame rate, up to what these change the field.

\throw Option_error, Cancelled as `align_animations()`.
*/
inline double animation_distance(const Activity& a, const Activity& b,
                                 const Distance_options& options = Distance_options())
{
  if (!(options.cycle_weight >= 0 && options.cycle_weight <= 1))
    throw Option_error("the weight of cycles is from 0 to 1");
  const double cost = align_animations(a, b, options.alignment).cost;
  const double s = a.cycle.strength, t = b.cycle.strength;
  double unlike = std::abs(s - t);
  if (s > 0 && t > 0) unlike += (std::min)(s, t) * (std::min)(std::abs(std::log2(a.cycle.period / b.cycle.period)), 1.);
  return 1 - (1 - cost) * (1 - options.cycle_weight * (std::min)(unlike, 1.));
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_DISTANCE_H
