// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_MATCH_FEATURES_H
#define CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_MATCH_FEATURES_H

#include <CGAL/Animated_mesh_features/Descriptors/Described_features.h>
#include <CGAL/Animated_mesh_features/Descriptors/Matching_options.h>
#include <CGAL/Animated_mesh_features/Descriptors/internal/Candidate_pairs.h>
#include <CGAL/Animated_mesh_features/Descriptors/internal/Consistent_pairs.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

pairs features of two animations that show the same event, without any correspondence between their meshes.

1. Candidates: for each of the strongest features of either animation those of the other one that are most alike in
   descriptor, place on the body, \f$\sigma\f$ relative to the size, \f$\tau\f$ and amplitude; see `Matching_options`,
   also for the ratio test and for mutual nearest neighbours only.
2. Consistency: two pairs agree as far as the distances between the two features on either surface are the same,
   relative to the size, and so are the times between them. Candidates are weighted by the principal eigenvector of the
   matrix of all agreements (Leordeanu and Hebert \cgalCite{leordeanu2005}).
3. From the best ones sets of pairs are grown that agree with one another, each feature in one pair only. Of a body
   and its mirror image all distances are the same; of two sets the one is preferred whose places on the rest shapes map
   by a rotation and not by a reflection.

Of a loop, see `Described_features::loop`, times are known but for ways around.

`O(C^2)` time and memory for `C` candidates, of which there are at most `2 top candidates`.

\param a, b the features.
\param options weights and limits.
\param may_match called with ranks in `a` and `b`: whether the two may be a pair; see `match_aligned_features()`.
\returns pairs, the most confident ones first. None, if either side has no features.
\throw Option_error if an option is out of its range; Cancelled if it is called in a task of a `Task_loop`, whose visitor is
  asked every tenth of a second, and has had enough.
*/
template <class MayMatch>
std::vector<Feature_match> match_features(const Described_features& a, const Described_features& b,
                                          const Matching_options& options, const MayMatch& may_match)
{
  options.check();
  const std::vector<internal::Candidate_pair> candidates = internal::candidate_pairs(a, b, options, may_match);
  return internal::Consistent_pairs(a, b, candidates, options).matches();
}

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

the same of all pairs.
*/
inline std::vector<Feature_match> match_features(const Described_features& a, const Described_features& b,
                                                 const Matching_options& options = Matching_options())
{
  return match_features(a, b, options, [](std::size_t, std::size_t) { return true; });
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_MATCH_FEATURES_H
