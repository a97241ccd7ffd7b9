// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_ALL_FINITE_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_ALL_FINITE_H

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Whether all of `n` numbers are finite, nearly as fast as they come from memory: by bits, without a branch in the loop,
// which also -ffast-math leaves alone. `lowest` is the lowest bit of the exponent; adding it to the exponent overflows
// into the sign, which was cleared, if and only if the exponent is the largest.
template <class Bits, class FT>
bool all_finite_by_bits(const FT* x, std::size_t n, Bits exponent, Bits lowest)
{
  static_assert(sizeof(Bits) == sizeof(FT), "the bits of the number");
  const auto overflow = [&](std::size_t i) {
    Bits bits;
    std::memcpy(&bits, x + i, sizeof(bits));
    return static_cast<Bits>((bits & exponent) + lowest);
  };
  Bits a = 0, b = 0, c = 0, d = 0; // none waits for another
  std::size_t i = 0;
  for (; i + 4 <= n; i += 4) {
    a |= overflow(i);
    b |= overflow(i + 1);
    c |= overflow(i + 2);
    d |= overflow(i + 3);
  }
  for (; i < n; ++i) a |= overflow(i);
  return ((a | b | c | d) & (exponent + lowest)) == 0;
}

inline bool all_finite(const float* x, std::size_t n)
{
  return all_finite_by_bits<std::uint32_t>(x, n, 0x7f800000u, 0x00800000u);
}

inline bool all_finite(const double* x, std::size_t n)
{
  return all_finite_by_bits<std::uint64_t>(x, n, 0x7ff0000000000000u, 0x0010000000000000u);
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_ALL_FINITE_H
