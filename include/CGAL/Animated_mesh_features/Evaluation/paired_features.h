// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_PAIRED_FEATURES_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_PAIRED_FEATURES_H

#include <CGAL/Animated_mesh_features/Evaluation/Placed_feature.h>
#include <CGAL/Animated_mesh_features/Evaluation/maximum_matching.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

Which features of the shorter of two lists have a partner of their own in the other: a number for each, 1 or 0, so that
the mean is the share. With scales the pairs are other ones, as many as can be.
*/
struct Paired_features
{
  std::vector<double> in_place_and_time; ///< pairs at the same place and time
  std::vector<double> with_scales;       ///< pairs that have the same scales, too
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

pairs the features of two lists one-to-one, as many as can be, see `maximum_matching()`. Stricter than
`repeated_features()`: a crowd of features is not found again by a single one.

`O(n m)` for the two lengths, and the matching, \f$O(E \sqrt{n + m})\f$ for `E` pairs within the gates.

\param a, b the lists; the shorter one, `a` of equal ones, is what the result is about.
\param gates how near is near enough.
*/
inline Paired_features paired_features(const std::vector<Placed_feature>& a, const std::vector<Placed_feature>& b,
                                       const Matching_gates& gates)
{
  const std::vector<Placed_feature>& shorter = b.size() < a.size() ? b : a;
  const std::vector<Placed_feature>& longer = b.size() < a.size() ? a : b;
  Compressed_rows near_ones, similar_ones;
  std::vector<Compressed_rows::Index> nearby, similar;
  for (const Placed_feature& f : shorter) {
    nearby.clear();
    similar.clear();
    for (std::size_t k = 0; k < longer.size(); ++k) {
      if (!are_at_same_place_and_time(f, longer[k], gates)) continue;
      nearby.push_back(Compressed_rows::Index(k));
      if (have_same_scales(f, longer[k], gates)) similar.push_back(Compressed_rows::Index(k));
    }
    near_ones.push_back(nearby.begin(), nearby.end());
    similar_ones.push_back(similar.begin(), similar.end());
  }
  const auto has_partner = [&](const Compressed_rows& partners) {
    std::vector<double> result;
    for (std::size_t partner : maximum_matching(partners, longer.size()).right_of_left)
      result.push_back(partner == Bipartite_matching::none ? 0 : 1);
    return result;
  };
  return {has_partner(near_ones), has_partner(similar_ones)};
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_PAIRED_FEATURES_H
