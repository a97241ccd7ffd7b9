// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_MATCH_ALIGNED_FEATURES_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_MATCH_ALIGNED_FEATURES_H

#include <CGAL/Animated_mesh_features/Applications/Animation_signature.h>
#include <CGAL/Animated_mesh_features/Applications/Time_alignment.h>
#include <CGAL/Animated_mesh_features/Descriptors/match_features.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

pairs features of two animations as `match_features()` does, in the cycle in which the alignment has them: of motions that
both repeat themselves, as steps do, the features of one cycle are as those of another, and pairs that agree with each
other may be all a cycle late. A pair may then be late by half of the shorter period at most. Other motions are matched
without regard to the alignment.

\param a, b the animations.
\param alignment of their times, see `align_animations()`.
\param options weights and limits.
\throw Option_error if an option is out of its range; Cancelled as `match_features()`.
*/
inline std::vector<Feature_match> match_aligned_features(const Animation_signature& a, const Animation_signature& b,
                                                         const Time_alignment& alignment,
                                                         const Matching_options& options = Matching_options())
{
  const double period = (std::min)(a.activity.cycle.period, b.activity.cycle.period);
  return match_features(a.events, b.events, options, [&](std::size_t i, std::size_t j) {
    const double late = alignment.lateness(a.events.features[i].time, b.events.features[j].time);
    return !(period > 0) || std::abs(late) <= period / 2;
  });
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_MATCH_ALIGNED_FEATURES_H
