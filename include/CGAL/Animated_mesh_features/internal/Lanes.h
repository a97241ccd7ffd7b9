// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_LANES_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_LANES_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

// Vector extensions of the compiler rather than loops that it may or may not vectorise: CGAL compiles with
// -frounding-math, with which g++ leaves plain loops alone.
#if defined(__GNUC__)
  #define CGAL_ANIMATED_MESH_FEATURES_HAS_VECTOR_TYPES 1
  #define CGAL_ANIMATED_MESH_FEATURES_INLINE inline __attribute__((always_inline))
#else
  #define CGAL_ANIMATED_MESH_FEATURES_INLINE inline
#endif
#if defined(__clang__)
  #define CGAL_ANIMATED_MESH_FEATURES_UNROLL _Pragma("clang loop unroll(full)")
#elif defined(__GNUC__)
  #define CGAL_ANIMATED_MESH_FEATURES_UNROLL _Pragma("GCC unroll 32")
#else
  #define CGAL_ANIMATED_MESH_FEATURES_UNROLL
#endif

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A register of that many bytes; as wide as one number, the number itself.
template <class T, std::size_t bytes>
struct Register
{
  static_assert(bytes == sizeof(T), "this compiler has no vector types");
  typedef T type;
};

#ifdef CGAL_ANIMATED_MESH_FEATURES_HAS_VECTOR_TYPES
  // g++ 12 takes the attribute of a dependent type for that of its element: each type by its name.
  #define CGAL_ANIMATED_MESH_FEATURES_REGISTER(T, bytes) \
    template <> \
    struct Register<T, bytes> \
    { \
      typedef T type __attribute__((vector_size(bytes))); \
    };
  #define CGAL_ANIMATED_MESH_FEATURES_REGISTERS(T) \
    CGAL_ANIMATED_MESH_FEATURES_REGISTER(T, 16) \
    CGAL_ANIMATED_MESH_FEATURES_REGISTER(T, 32) \
    CGAL_ANIMATED_MESH_FEATURES_REGISTER(T, 64)
CGAL_ANIMATED_MESH_FEATURES_REGISTERS(float)
CGAL_ANIMATED_MESH_FEATURES_REGISTERS(double)
CGAL_ANIMATED_MESH_FEATURES_REGISTERS(std::int32_t)
CGAL_ANIMATED_MESH_FEATURES_REGISTERS(std::int64_t)
  #undef CGAL_ANIMATED_MESH_FEATURES_REGISTERS
  #undef CGAL_ANIMATED_MESH_FEATURES_REGISTER
#endif

// `size` numbers that are computed with as one, in registers of `register_bytes` each.
template <class T, std::size_t size_, std::size_t register_bytes>
struct Lanes
{
  typedef T Scalar;
  typedef typename Register<T, register_bytes>::type Register_type;
  static constexpr std::size_t size = size_;
  static constexpr std::size_t registers = size * sizeof(T) / register_bytes;
  static_assert(registers * register_bytes == size * sizeof(T), "lanes are whole registers");

  Register_type r[registers];

  static CGAL_ANIMATED_MESH_FEATURES_INLINE Lanes all(T value)
  {
    T values[size];
    std::fill(values, values + size, value);
    return load(values);
  }
  static CGAL_ANIMATED_MESH_FEATURES_INLINE Lanes load(const T* from) // no alignment needed
  {
    Lanes result;
    std::memcpy(&result, from, sizeof(result));
    return result;
  }
  CGAL_ANIMATED_MESH_FEATURES_INLINE void store(T* to) const { std::memcpy(to, this, sizeof(*this)); }
};

#define CGAL_ANIMATED_MESH_FEATURES_LANES_OPERATOR(op) \
  template <class T, std::size_t n, std::size_t b> \
  CGAL_ANIMATED_MESH_FEATURES_INLINE Lanes<T, n, b> operator op(const Lanes<T, n, b>& x, const Lanes<T, n, b>& y) \
  { \
    Lanes<T, n, b> result; \
    CGAL_ANIMATED_MESH_FEATURES_UNROLL \
    for (std::size_t i = 0; i < result.registers; ++i) result.r[i] = x.r[i] op y.r[i]; \
    return result; \
  }
CGAL_ANIMATED_MESH_FEATURES_LANES_OPERATOR(+)
CGAL_ANIMATED_MESH_FEATURES_LANES_OPERATOR(-)
CGAL_ANIMATED_MESH_FEATURES_LANES_OPERATOR(*)
#undef CGAL_ANIMATED_MESH_FEATURES_LANES_OPERATOR

template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE Lanes<T, n, b> operator*(const Lanes<T, n, b>& x, T y)
{
  Lanes<T, n, b> result;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < result.registers; ++i) result.r[i] = x.r[i] * y;
  return result;
}

// The lanes of two chains that go through the same filter, so that each hides the latency of the other.
template <class L>
struct Lane_pair
{
  typedef typename L::Scalar Scalar;
  L p, q;

  CGAL_ANIMATED_MESH_FEATURES_INLINE friend Lane_pair operator+(const Lane_pair& a, const Lane_pair& b)
  {
    return {a.p + b.p, a.q + b.q};
  }
  CGAL_ANIMATED_MESH_FEATURES_INLINE friend Lane_pair operator-(const Lane_pair& a, const Lane_pair& b)
  {
    return {a.p - b.p, a.q - b.q};
  }
  CGAL_ANIMATED_MESH_FEATURES_INLINE friend Lane_pair operator*(const Lane_pair& a, Scalar b)
  {
    return {a.p * b, a.q * b};
  }
};

// The scalar of lanes, or a number's own type.
template <class T, class = void>
struct Scalar_of
{
  typedef T type;
};
template <class T>
struct Scalar_of<T, std::void_t<typename T::Scalar>>
{
  typedef typename T::Scalar type;
};

// Whether there is a lane in which all three are negative. By their signs: comparing vectors is what g++ 12 does lane by
// lane for 64 bytes. (A difference of unlike numbers is never zero, and of like ones +0.)
template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE bool
any_negative(const Lanes<T, n, b>& x, const Lanes<T, n, b>& y, const Lanes<T, n, b>& z)
{
  typedef std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t> Integer;
  typedef std::conditional_t<b == 4, std::int32_t, std::int64_t> Word;
  typedef typename Register<Integer, b>::type Bits;
  Bits all;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < Lanes<T, n, b>::registers; ++i) {
    Bits u, v, w;
    std::memcpy(&u, &x.r[i], b);
    std::memcpy(&v, &y.r[i], b);
    std::memcpy(&w, &z.r[i], b);
    const Bits signs = u & v & w;
    all = i == 0 ? signs : all | signs;
  }
  constexpr std::size_t words = b / sizeof(Word);
  Word word[words], result = 0;
  std::memcpy(word, &all, b);
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < words; ++i) result |= word[i];
  constexpr Word sign_bits = sizeof(Word) == 8 && sizeof(T) == 4 ? Word(0x8000000080000000ull)
                             : sizeof(Word) == 8                 ? Word(0x8000000000000000ull)
                                                                 : Word(0x80000000u);
  return (result & sign_bits) != 0;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_LANES_H
