// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_WINDOW_SUM_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_WINDOW_SUM_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The sum of the last `width` values of a stream; values before the first are zero.
//
// By doubling: the sum of 2 m values is that of the last m and that of the m before them, which costs log2(width)
// additions a value, some more for odd widths; nothing is ever subtracted. All that is remembered are `width` values or
// fewer. They are passed on like in a pipe, which costs nothing where the loop is unrolled `period` times: after as
// many values each of them is in its place again, in the same register.
template <class T, std::size_t width>
class Window_sum
{
  static constexpr std::size_t half = width / 2;
  static constexpr bool is_odd = width % 2 == 1;
  typedef Window_sum<T, half> Half;

  static constexpr std::size_t least_common_multiple(std::size_t a, std::size_t b)
  {
    std::size_t m = a;
    while (m % b != 0) m += a;
    return m;
  }

public:
  static constexpr std::size_t period = least_common_multiple(half, Half::period);

  explicit CGAL_ANIMATED_MESH_FEATURES_INLINE Window_sum(const T& zero)
    : m_half(zero)
    , m_even(zero)
  {
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 0; i < half; ++i) m_halves[i] = zero;
  }

  CGAL_ANIMATED_MESH_FEATURES_INLINE T push(const T& value)
  {
    const T sum = m_half.push(value), even = m_halves[0] + sum;
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 1; i < half; ++i) m_halves[i - 1] = m_halves[i];
    m_halves[half - 1] = sum;
    if (!is_odd) return even;
    const T odd = m_even + value;
    m_even = even;
    return odd;
  }

private:
  Half m_half;
  T m_halves[half]; // the last sums of m_half
  T m_even;         // the last sum of 2 half values
};

template <class T>
class Window_sum<T, 1>
{
public:
  static constexpr std::size_t period = 1;

  explicit CGAL_ANIMATED_MESH_FEATURES_INLINE Window_sum(const T&) {}
  CGAL_ANIMATED_MESH_FEATURES_INLINE T push(const T& value) { return value; }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_WINDOW_SUM_H
