// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_SURROGATES_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_SURROGATES_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Samples in another order that keeps what is next to each other, but for few of them: the k-th rearrangement, the
// first of which is backwards; others shuffle pieces of a third of a second, every second one of them backwards.
inline std::vector<std::size_t> surrogate_order(std::size_t samples, double sample_duration, std::size_t k)
{
  const double piece_duration = 1. / 3;
  const std::size_t wanted = std::size_t(std::lround(piece_duration / sample_duration));
  // at least four pieces, or there is nothing to be shuffled
  const std::size_t piece = (std::max)(std::size_t(1), (std::min)(wanted, samples / 4));
  std::vector<std::size_t> pieces, order;
  for (std::size_t t = 0; t < samples; t += piece) pieces.push_back(t);
  if (k > 0) {
    std::uint64_t state = 0x9e3779b97f4a7c15ull * (k + 1);
    for (std::size_t i = pieces.size(); i > 1; --i) {                  // Fisher and Yates
      state = state * 6364136223846793005ull + 1442695040888963407ull; // Knuth's MMIX
      std::swap(pieces[i - 1], pieces[std::size_t(state >> 33) % i]);
    }
  }
  for (std::size_t p : pieces)
    for (std::size_t t = p; t < (std::min)(p + piece, samples); ++t) order.push_back(t);
  if (k % 2 == 0) std::reverse(order.begin(), order.end());
  return order;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_SURROGATES_H
