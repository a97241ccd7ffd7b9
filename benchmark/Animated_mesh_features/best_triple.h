// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_BEST_TRIPLE_H
#define CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_BEST_TRIPLE_H

#include <CGAL/Animated_mesh_features/Applications/View_scores.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Benchmark {

// What the three of all directions show that show most together: an exhaustive search, to tell what a choice of three
// views could reach. What views show is submodular: a third one adds to two no more than it adds to either, so that most
// triples need not be looked at. `at_least`: what some triple shows.
inline double best_triple(const CGAL::Animated_mesh_features::View_scores& scores, double at_least)
{
  const std::size_t n = scores.directions().size();
  std::vector<double> pairs(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) pairs[i * n + j] = pairs[j * n + i] = scores.covered({i, j});
  const auto pair = [&](std::size_t i, std::size_t j) { return pairs[i * n + j]; };
  const double rounding = 1e-9;
  double best = at_least;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        const double ij = pair(i, j), ik = pair(i, k), jk = pair(j, k);
        const double most = (std::min)({ij + ik - pair(i, i), ij + jk - pair(j, j), ik + jk - pair(k, k)});
        if (most > best + rounding) best = (std::max)(best, scores.covered({i, j, k}));
      }
  return best;
}

} // namespace Benchmark

#endif // CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_BEST_TRIPLE_H
