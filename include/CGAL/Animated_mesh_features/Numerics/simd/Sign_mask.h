// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_SIGN_MASK_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_SIGN_MASK_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Integers as wide as a number.
template <class T>
struct Bits_of
{
  typedef std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t> type;
};

// The signs of the numbers of a pack, to be combined. (Comparing vectors is what g++ 12 does number by number for
// registers of 64 bytes. A difference of unlike numbers is never zero, and of like ones +0.)
template <class T, std::size_t n, std::size_t b>
class Sign_mask
{
  typedef typename Register<typename Bits_of<T>::type, b>::type Bits;
  static constexpr std::size_t registers = Pack<T, n, b>::registers;

public:
  explicit CGAL_ANIMATED_MESH_FEATURES_INLINE Sign_mask(const Pack<T, n, b>& x)
  {
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 0; i < registers; ++i) std::memcpy(&m_bits[i], &x.r[i], b);
  }

  CGAL_ANIMATED_MESH_FEATURES_INLINE friend Sign_mask operator&(const Sign_mask& x, const Sign_mask& y)
  {
    Sign_mask result = x;
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 0; i < registers; ++i) result.m_bits[i] &= y.m_bits[i];
    return result;
  }

  // a register, of which the highest bit of each number is the sign
  CGAL_ANIMATED_MESH_FEATURES_INLINE const Bits& bits(std::size_t i) const { return m_bits[i]; }

private:
  Bits m_bits[registers];
};

// The integers of a register, each or-ed with all others.
template <class Integer, std::size_t bytes>
CGAL_ANIMATED_MESH_FEATURES_INLINE Integer any_bits(const typename Register<Integer, bytes>::type& bits)
{
  if constexpr (bytes > 16) {
    typename Register<Integer, bytes / 2>::type half[2];
    std::memcpy(half, &bits, bytes);
    return any_bits<Integer, bytes / 2>(half[0] | half[1]);
  } else {
    Integer integers[bytes / sizeof(Integer)], result = 0;
    std::memcpy(integers, &bits, bytes);
    for (Integer i : integers) result |= i;
    return result;
  }
}

// For each number of a pack the signs that were pushed last, as the bits of an integer: of `size` of them the first is
// bit 0.
template <class T, std::size_t n, std::size_t b>
class alignas(b) Sign_history
{
  static constexpr std::size_t registers = Pack<T, n, b>::registers;

public:
  typedef typename Bits_of<T>::type Integer;
  static constexpr std::size_t size = 8 * sizeof(T);

  CGAL_ANIMATED_MESH_FEATURES_INLINE void push(const Sign_mask<T, n, b>& signs)
  {
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 0; i < registers; ++i) m_bits[i] = (m_bits[i] >> 1) | (signs.bits(i) & last);
  }

  // The signs of `signs` of the numbers that have bit i.
  CGAL_ANIMATED_MESH_FEATURES_INLINE Sign_history that_have(std::size_t i, const Sign_mask<T, n, b>& signs) const
  {
    Sign_history result;
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t j = 0; j < registers; ++j)
      result.m_bits[j] = (m_bits[j] << int(size - 1 - i)) & (signs.bits(j) & last);
    return result;
  }

  // the bits that any number has
  CGAL_ANIMATED_MESH_FEATURES_INLINE Integer any() const
  {
    Bits all = m_bits[0];
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 1; i < registers; ++i) all |= m_bits[i];
    return any_bits<Integer, b>(all);
  }

  CGAL_ANIMATED_MESH_FEATURES_INLINE void store(Integer* to) const { std::memcpy(to, m_bits, sizeof(m_bits)); }

private:
  typedef typename Register<Integer, b>::type Bits;
  static constexpr Integer last = Integer(1) << (size - 1);

  Bits m_bits[registers] = {};
};

template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE Sign_mask<T, n, b> negative(const Pack<T, n, b>& x)
{
  return Sign_mask<T, n, b>(x);
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_SIGN_MASK_H
