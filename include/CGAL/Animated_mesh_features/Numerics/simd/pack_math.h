// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_PACK_MATH_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_PACK_MATH_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#if defined(__SSE2__) && defined(CGAL_ANIMATED_MESH_FEATURES_HAS_VECTOR_TYPES)
  #include <emmintrin.h>
  #define CGAL_ANIMATED_MESH_FEATURES_HAS_SSE2 1
#endif

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Functions of packs, without branches. Each operation is rounded as that of a single number is, so that results do not
// depend on the width of the registers.

template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<T, n, b> operator/(const Pack<T, n, b>& x, const Pack<T, n, b>& y)
{
  Pack<T, n, b> result;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < result.registers; ++i) result.r[i] = x.r[i] / y.r[i];
  return result;
}

template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<T, n, b> operator+(const Pack<T, n, b>& x, T y)
{
  Pack<T, n, b> result;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < result.registers; ++i) result.r[i] = x.r[i] + y;
  return result;
}

template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<T, n, b> operator-(const Pack<T, n, b>& x, T y)
{
  Pack<T, n, b> result;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < result.registers; ++i) result.r[i] = x.r[i] - y;
  return result;
}

template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<T, n, b> abs(const Pack<T, n, b>& x)
{
  return absolute(x);
}

// a > b ? x : y
template <class T, std::size_t n, std::size_t b_>
CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<T, n, b_> where_greater(const Pack<T, n, b_>& a, const Pack<T, n, b_>& b,
                                                                 const Pack<T, n, b_>& x, const Pack<T, n, b_>& y)
{
  Pack<T, n, b_> result;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < result.registers; ++i) result.r[i] = a.r[i] > b.r[i] ? x.r[i] : y.r[i];
  return result;
}

// The second where the first is not a number.
template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<T, n, b> maximum(const Pack<T, n, b>& x, const Pack<T, n, b>& y)
{
  return where_greater(x, y, x, y);
}

// Compilers have no square root of vectors of any width, and intrinsic functions for AVX cannot be called from where it
// is not known yet that there is AVX. Those for SSE2 can: wider registers are taken apart, which costs some 6 % of what
// the measures take.
template <class R>
CGAL_ANIMATED_MESH_FEATURES_INLINE void root_of_register(const R& x, R& root)
{
  root = std::sqrt(x);
}
#ifdef CGAL_ANIMATED_MESH_FEATURES_HAS_SSE2
typedef Register<float, 16>::type Register_of_4_floats;
typedef Register<float, 32>::type Register_of_8_floats;
typedef Register<double, 16>::type Register_of_2_doubles;
typedef Register<double, 32>::type Register_of_4_doubles;

template <>
CGAL_ANIMATED_MESH_FEATURES_INLINE void root_of_register(const Register_of_4_floats& x, Register_of_4_floats& root)
{
  root = _mm_sqrt_ps(x);
}
template <>
CGAL_ANIMATED_MESH_FEATURES_INLINE void root_of_register(const Register_of_2_doubles& x, Register_of_2_doubles& root)
{
  root = _mm_sqrt_pd(x);
}
template <>
CGAL_ANIMATED_MESH_FEATURES_INLINE void root_of_register(const Register_of_8_floats& x, Register_of_8_floats& root)
{
  const Register_of_4_floats low = _mm_sqrt_ps(__builtin_shufflevector(x, x, 0, 1, 2, 3));
  const Register_of_4_floats high = _mm_sqrt_ps(__builtin_shufflevector(x, x, 4, 5, 6, 7));
  root = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
template <>
CGAL_ANIMATED_MESH_FEATURES_INLINE void root_of_register(const Register_of_4_doubles& x, Register_of_4_doubles& root)
{
  const Register_of_2_doubles low = _mm_sqrt_pd(__builtin_shufflevector(x, x, 0, 1));
  const Register_of_2_doubles high = _mm_sqrt_pd(__builtin_shufflevector(x, x, 2, 3));
  root = __builtin_shufflevector(low, high, 0, 1, 2, 3);
}
#endif

template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<T, n, b> sqrt(const Pack<T, n, b>& x)
{
  Pack<T, n, b> result;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < result.registers; ++i) root_of_register(x.r[i], result.r[i]);
  return result;
}

// The natural logarithm of positive normal numbers: ln(2^k m) = k ln 2 + 2 artanh((m - 1) / (m + 1)) with m from
// sqrt(1/2) to sqrt(2). Near 1 the error is relative to the result, a few roundings.
template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<T, n, b> log(const Pack<T, n, b>& x)
{
  typedef Pack<T, n, b> P;
  typedef std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t> Integer;
  typedef typename Register<Integer, b>::type Bits;
  constexpr int digits = std::numeric_limits<T>::digits - 1;                           // of a mantissa, as it is stored
  constexpr Integer one = Integer(std::numeric_limits<T>::max_exponent - 1) << digits; // the bits of 1
  constexpr Integer root = one - (Integer(1) << digits) +                              // the bits of sqrt(1/2)
                           Integer(0.41421356237309505 * double(Integer(1) << digits));
  // Adding this to an integer makes the bits of a number that is larger by `large`.
  constexpr T large = T(Integer(3) << (digits - 1));
  constexpr Integer large_bits = one + (Integer(digits) << digits) + (Integer(1) << (digits - 1));
  P mantissa, exponent;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < P::registers; ++i) {
    Bits bits;
    std::memcpy(&bits, &x.r[i], b);
    // positive, as x is at least the smallest normal number
    const Bits shifted = (bits + (one - root)) >> digits;
    const Bits power = shifted - (one >> digits);
    bits -= power << digits;
    std::memcpy(&mantissa.r[i], &bits, b);
    const Bits number = power + large_bits;
    std::memcpy(&exponent.r[i], &number, b);
  }
  exponent = exponent - large;
  const P s = (mantissa - T(1)) / (mantissa + T(1)), square = s * s;
  // |s| < 0.172: 0.172^(2 i) / (2 i + 1) is below the rounding at i = 5 for float, i = 11 for double
  constexpr int terms = sizeof(T) == sizeof(float) ? 5 : 11;
  P sum = P::all(T(2) / T(2 * terms - 1));
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (int i = 0; i < terms - 1; ++i) sum = sum * square + T(2) / T(2 * (terms - 2 - i) + 1);
  return exponent * T(0.69314718055994531) + s * sum;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_PACK_MATH_H
