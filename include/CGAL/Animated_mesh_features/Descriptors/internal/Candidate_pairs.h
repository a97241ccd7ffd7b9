// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_INTERNAL_CANDIDATE_PAIRS_H
#define CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_INTERNAL_CANDIDATE_PAIRS_H

#include <CGAL/Animated_mesh_features/Descriptors/Described_features.h>
#include <CGAL/Animated_mesh_features/Descriptors/Matching_options.h>
#include <CGAL/Animated_mesh_features/Descriptors/feature_difference.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

struct Candidate_pair
{
  std::size_t a, b; // ranks
  double difference;
};

// Pairs that are worth looking at, by ranks; each once. Those of which `may_match(i, j)` is false are none.
template <class MayMatch>
std::vector<Candidate_pair> candidate_pairs(const Described_features& a, const Described_features& b,
                                            const Matching_options& o, const MayMatch& may_match)
{
  const std::vector<std::size_t> of_a = strongest_features(a.features, o.top);
  const std::vector<std::size_t> of_b = strongest_features(b.features, o.top);
  const std::size_t n = of_a.size(), m = of_b.size();
  std::vector<double> differences(n * m);
  for (std::size_t i = 0; i < n; ++i) {
    cancellation_point();
    for (std::size_t j = 0; j < m; ++j)
      differences[i * m + j] = may_match(of_a[i], of_b[j]) ? feature_difference(a, of_a[i], b, of_b[j], o)
                                                           : std::numeric_limits<double>::infinity();
  }

  // how often a pair is among the nearest of either of its features, and how often it is the nearest
  std::vector<unsigned char> near(n * m, 0), nearest(n * m, 0);
  const auto look = [&](std::size_t count, const auto& cell) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t(0));
    const std::size_t k = (std::min)(o.candidates, count), kept = (std::min)((std::max)(k, std::size_t(2)), count);
    std::partial_sort(order.begin(), order.begin() + std::ptrdiff_t(kept), order.end(),
                      [&](std::size_t x, std::size_t y) {
                        return std::make_pair(differences[cell(x)], x) < std::make_pair(differences[cell(y)], y);
                      });
    if (count == 0) return;
    if (o.max_ratio < 1 && count > 1 && !(differences[cell(order[0])] < o.max_ratio * differences[cell(order[1])]))
      return;
    for (std::size_t i = 0; i < k; ++i) ++near[cell(order[i])];
    ++nearest[cell(order[0])];
  };
  for (std::size_t i = 0; i < n; ++i) look(m, [&](std::size_t j) { return i * m + j; });
  for (std::size_t j = 0; j < m; ++j) look(n, [&](std::size_t i) { return i * m + j; });

  std::vector<Candidate_pair> result;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j)
      if (std::isfinite(differences[i * m + j]) && (o.mutual_nearest ? nearest[i * m + j] == 2 : near[i * m + j] > 0))
        result.push_back({of_a[i], of_b[j], differences[i * m + j]});
  return result;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_INTERNAL_CANDIDATE_PAIRS_H
