// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_RANDOM_NUMBERS_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_RANDOM_NUMBERS_H

#include <cstddef>
#include <cstdint>
#include <random>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

The random numbers of chance levels and of resampling: from the same seed the same ones on every platform, which the
distributions of the standard library do not promise.
*/
class Random_numbers
{
public:
  /// a sequence of its own for each seed.
  explicit Random_numbers(std::uint64_t seed)
    : m_bits(seed)
  {}

  /// uniform in [0, 1), with 53 random bits.
  double uniform() { return double(m_bits() >> 11) / 9007199254740992.; }

  /// uniform in [from, to).
  double uniform(double from, double to) { return from + (to - from) * uniform(); }

  /// uniform among 0, ..., `n` - 1; `n` is positive and below 2^53.
  std::size_t below(std::size_t n) { return std::size_t(uniform() * double(n)); }

private:
  std::mt19937_64 m_bits;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_RANDOM_NUMBERS_H
