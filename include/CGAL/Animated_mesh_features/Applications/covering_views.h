// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_COVERING_VIEWS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_COVERING_VIEWS_H

#include <CGAL/Animated_mesh_features/Applications/View_scores.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesViews

One of the views that `covering_views()` chose.
*/
struct Covering_view
{
  std::size_t rank = 0; ///< of the direction in `View_scores::directions()`
  double score = 0;     ///< what it shows alone, from 0 to 1
  double covered = 0;   ///< what it and those before it show together, from 0 to 1
};

/*!
\ingroup PkgAnimatedMeshFeaturesViews

chooses views that together show most: the best one, and then, again and again, the one that adds most to those that are
chosen. What `k` views show is submodular, so this is at least \f$1 - 1/e\f$, 63 %, of what the best `k` views show
(G. Nemhauser, L. Wolsey, M. Fisher, 1978).

\param scores of `D` directions and `I` items.
\param most how many. Fewer are chosen if there are fewer, or no other adds anything.
\param is_allowed `bool(const Eigen::Vector3d& direction)`: whether a direction may be chosen.

Takes \f$O(k D I)\f$ time.
*/
template <class Predicate>
std::vector<Covering_view> covering_views(const View_scores& scores, std::size_t most, const Predicate& is_allowed)
{
  std::vector<Covering_view> result;
  std::vector<std::uint8_t> seen(scores.number_of_items(), 0), trial;
  double covered = 0;
  while (result.size() < most) {
    Covering_view best;
    bool is_found = false;
    if (result.empty()) {
      best.rank = scores.best(is_allowed);
      is_found = best.rank < scores.directions().size();
    } else {
      for (std::size_t d = 0; d < scores.directions().size(); ++d) {
        if (!is_allowed(scores.directions()[d])) continue;
        trial = seen;
        scores.add_seen(d, trial);
        const double now = scores.worth(trial);
        if (!(now > covered && (!is_found || now > best.covered))) continue;
        best.rank = d;
        best.covered = now;
        is_found = true;
      }
    }
    if (!is_found) break;
    scores.add_seen(best.rank, seen);
    best.score = scores.score(best.rank);
    covered = best.covered = scores.worth(seen);
    result.push_back(best);
  }
  return result;
}

/*!
\ingroup PkgAnimatedMeshFeaturesViews

chooses among all directions.
*/
inline std::vector<Covering_view> covering_views(const View_scores& scores, std::size_t most)
{
  return covering_views(scores, most, [](const Eigen::Vector3d&) { return true; });
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_COVERING_VIEWS_H
