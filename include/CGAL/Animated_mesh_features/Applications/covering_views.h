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
#include <optional>
#include <utility>
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

namespace internal {

// The direction that shows most together with what is seen, and what; `directions().size()` if none shows more.
template <class Predicate>
std::pair<std::size_t, double> best_addition(const View_scores& scores, const std::vector<std::uint8_t>& seen,
                                             const Predicate& is_allowed)
{
  std::pair<std::size_t, double> best(scores.directions().size(), scores.worth(seen));
  std::vector<std::uint8_t> trial;
  for (std::size_t d = 0; d < scores.directions().size(); ++d) {
    if (!is_allowed(scores.directions()[d])) continue;
    trial = seen;
    scores.add_seen(d, trial);
    const double worth = scores.worth(trial);
    if (worth > best.second) best = {d, worth};
  }
  return best;
}

// Puts another view in place of one of those after the first, as long as all of them show more then.
template <class Predicate>
void exchange_views(const View_scores& scores, const Predicate& is_allowed, std::vector<std::size_t>& views)
{
  const double least_gain = 1e-9; // of all: more than roundings
  double covered = scores.covered(views);
  for (bool is_better = views.size() > 2; is_better;) {
    is_better = false;
    for (std::size_t k = 1; k < views.size(); ++k) {
      std::vector<std::uint8_t> others(scores.number_of_items(), 0);
      for (std::size_t i = 0; i < views.size(); ++i)
        if (i != k) scores.add_seen(views[i], others);
      const std::pair<std::size_t, double> best = best_addition(scores, others, is_allowed);
      if (!(best.second > covered + least_gain)) continue;
      views[k] = best.first;
      covered = best.second;
      is_better = true;
    }
  }
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesViews

chooses views that together show most: the best one, and then, again and again, the one that adds most to those that are
chosen. What `k` views show is submodular, so this is at least \f$1 - 1/e\f$, 63 %, of what the best `k` views show
(G. Nemhauser, L. Wolsey, M. Fisher, 1978). Then each of them but the first is exchanged for the direction that shows
most together with all others, until none shows more.

\param scores of `D` directions and `I` items.
\param most how many. Fewer are chosen if there are fewer, or no other adds anything.
\param is_allowed `bool(const Eigen::Vector3d& direction)`: whether a direction may be chosen.
\param first the rank of the first view. Default: the best one.

Takes \f$O(k D I)\f$ time, and as much again for each round of exchanges, of which there are two to four.
*/
template <class Predicate>
std::vector<Covering_view> covering_views(const View_scores& scores, std::size_t most, const Predicate& is_allowed,
                                          std::optional<std::size_t> first = std::nullopt)
{
  std::vector<std::size_t> views;
  std::vector<std::uint8_t> seen(scores.number_of_items(), 0);
  while (views.size() < most) {
    const std::size_t next = !views.empty() ? internal::best_addition(scores, seen, is_allowed).first
                             : first        ? *first
                                            : scores.best(is_allowed);
    if (next == scores.directions().size()) break;
    scores.add_seen(next, seen);
    views.push_back(next);
  }
  internal::exchange_views(scores, is_allowed, views);
  std::vector<Covering_view> result;
  seen.assign(seen.size(), 0);
  while (!views.empty()) {
    // the first, then of those that are left the one that adds most
    std::size_t best = 0;
    double covered = -1;
    for (std::size_t i = 0; i < (result.empty() ? 1 : views.size()); ++i) {
      std::vector<std::uint8_t> trial = seen;
      scores.add_seen(views[i], trial);
      const double worth = scores.worth(trial);
      if (worth > covered) best = i, covered = worth;
    }
    scores.add_seen(views[best], seen);
    Covering_view view;
    view.rank = views[best];
    view.score = scores.score(view.rank);
    view.covered = covered;
    result.push_back(view);
    views.erase(views.begin() + std::ptrdiff_t(best));
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
