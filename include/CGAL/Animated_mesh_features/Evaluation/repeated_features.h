// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_REPEATED_FEATURES_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_REPEATED_FEATURES_H

#include <CGAL/Animated_mesh_features/Evaluation/Placed_feature.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

Which features of a list are found again in another one: a number for each that was looked up, 1 or 0, so that the mean is
the rate.
*/
struct Repeated_features
{
  std::vector<double> in_place_and_time; ///< some feature of the other list is at the same place and time
  std::vector<double> with_scales;       ///< one of these has the same scales, too
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

looks up the first `top` features of a list among the first `among` of another one: the repeatability of a detector, as it
is measured for interest points. Several features may find the same one; see `paired_features()` for one-to-one.

`O(top x among)`.

\param features what is looked up, strongest first.
\param others where, strongest first.
\param top, among how many of each.
\param gates how near is near enough.
*/
inline Repeated_features repeated_features(const std::vector<Placed_feature>& features,
                                           const std::vector<Placed_feature>& others, std::size_t top,
                                           std::size_t among, const Matching_gates& gates)
{
  Repeated_features result;
  const std::size_t n = (std::min)(top, features.size()), m = (std::min)(among, others.size());
  for (std::size_t i = 0; i < n; ++i) {
    bool is_there = false, has_scales = false;
    for (std::size_t k = 0; k < m && !has_scales; ++k) {
      if (!are_at_same_place_and_time(features[i], others[k], gates)) continue;
      is_there = true;
      has_scales = have_same_scales(features[i], others[k], gates);
    }
    result.in_place_and_time.push_back(is_there ? 1 : 0);
    result.with_scales.push_back(has_scales ? 1 : 0);
  }
  return result;
}

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

makes the chance level of `repeated_features()`: the same features at other times, as if the animation went round in a
circle and began elsewhere. Their places, and how they crowd in time, stay what they are.

\param features are to be moved.
\param shift by how much (s).
\param period the duration of the animation (s), positive.
*/
inline std::vector<Placed_feature> shifted_in_time(std::vector<Placed_feature> features, double shift, double period)
{
  for (Placed_feature& f : features) {
    f.time = std::fmod(f.time + shift, period);
    if (f.time < 0) f.time += period;
  }
  return features;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_REPEATED_FEATURES_H
