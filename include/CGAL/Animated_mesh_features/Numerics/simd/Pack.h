// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_PACK_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_PACK_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

// Vector extensions of the compiler rather than loops that it may or may not vectorise: CGAL compiles with
// -frounding-math, with which g++ leaves plain loops alone.
#if defined(__GNUC__)
  #define CGAL_ANIMATED_MESH_FEATURES_HAS_VECTOR_TYPES 1
  #define CGAL_ANIMATED_MESH_FEATURES_INLINE inline __attribute__((always_inline))
  #define CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA __attribute__((always_inline))
  // for what a vector loop seldom calls: not compiled anew for each set of instructions
  #define CGAL_ANIMATED_MESH_FEATURES_NO_INLINE __attribute__((noinline))
#else
  #define CGAL_ANIMATED_MESH_FEATURES_INLINE inline
  #define CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA
  #define CGAL_ANIMATED_MESH_FEATURES_NO_INLINE
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
  typedef T memory_type;
};

#ifdef CGAL_ANIMATED_MESH_FEATURES_HAS_VECTOR_TYPES
  // g++ 12 takes the attribute of a dependent type for that of its element: each type by its name.
  #define CGAL_ANIMATED_MESH_FEATURES_REGISTER(T, bytes)                                                               \
    template <>                                                                                                        \
    struct Register<T, bytes>                                                                                          \
    {                                                                                                                  \
      typedef T type __attribute__((vector_size(bytes)));                                                              \
      /* the same anywhere in memory, among numbers of type T */                                                       \
      typedef T memory_type __attribute__((vector_size(bytes), aligned(sizeof(T)), may_alias));                        \
    };
  #define CGAL_ANIMATED_MESH_FEATURES_REGISTERS(T)                                                                     \
    CGAL_ANIMATED_MESH_FEATURES_REGISTER(T, 16)                                                                        \
    CGAL_ANIMATED_MESH_FEATURES_REGISTER(T, 32)                                                                        \
    CGAL_ANIMATED_MESH_FEATURES_REGISTER(T, 64)
CGAL_ANIMATED_MESH_FEATURES_REGISTERS(float)
CGAL_ANIMATED_MESH_FEATURES_REGISTERS(double)
CGAL_ANIMATED_MESH_FEATURES_REGISTERS(std::int32_t)
CGAL_ANIMATED_MESH_FEATURES_REGISTERS(std::int64_t)
CGAL_ANIMATED_MESH_FEATURES_REGISTERS(std::uint32_t)
CGAL_ANIMATED_MESH_FEATURES_REGISTERS(std::uint64_t)
  #undef CGAL_ANIMATED_MESH_FEATURES_REGISTERS
  #undef CGAL_ANIMATED_MESH_FEATURES_REGISTER
#endif

// `size` numbers that are computed with as one, in registers of `register_bytes` each.
template <class T, std::size_t size_, std::size_t register_bytes>
struct alignas(register_bytes) Pack // said again, since g++ forgets it of the register's type
{
  typedef T Scalar;
  typedef typename Register<T, register_bytes>::type Register_type;
  typedef typename Register<T, register_bytes>::memory_type Memory_type;
  static constexpr std::size_t size = size_;
  static constexpr std::size_t registers = size * sizeof(T) / register_bytes;
  static_assert(registers * register_bytes == size * sizeof(T), "a pack fills whole registers");

  Register_type r[registers];

  static CGAL_ANIMATED_MESH_FEATURES_INLINE Pack all(T value)
  {
    // by integers: with -frounding-math, a sum with zero is a sum at run time
    typedef std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t> Integer;
    Integer bits;
    std::memcpy(&bits, &value, sizeof(T));
    const typename Register<Integer, register_bytes>::type all_bits =
        typename Register<Integer, register_bytes>::type{} | bits;
    Pack result;
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 0; i < registers; ++i) std::memcpy(&result.r[i], &all_bits, register_bytes);
    return result;
  }
  // No alignment needed. Register by register: g++ 12 copies larger objects by 16 bytes, through the stack.
  static CGAL_ANIMATED_MESH_FEATURES_INLINE Pack load(const T* from)
  {
    Pack result;
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 0; i < registers; ++i)
      result.r[i] = *reinterpret_cast<const Memory_type*>(from + i * (size / registers));
    return result;
  }
  CGAL_ANIMATED_MESH_FEATURES_INLINE void store(T* to) const
  {
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 0; i < registers; ++i) *reinterpret_cast<Memory_type*>(to + i * (size / registers)) = r[i];
  }
};

#define CGAL_ANIMATED_MESH_FEATURES_PACK_OPERATOR(op)                                                                  \
  template <class T, std::size_t n, std::size_t b>                                                                     \
  CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<T, n, b> operator op(const Pack<T, n, b>& x, const Pack<T, n, b>& y)         \
  {                                                                                                                    \
    Pack<T, n, b> result;                                                                                              \
    CGAL_ANIMATED_MESH_FEATURES_UNROLL                                                                                 \
    for (std::size_t i = 0; i < result.registers; ++i) result.r[i] = x.r[i] op y.r[i];                                 \
    return result;                                                                                                     \
  }
CGAL_ANIMATED_MESH_FEATURES_PACK_OPERATOR(+)
CGAL_ANIMATED_MESH_FEATURES_PACK_OPERATOR(-)
CGAL_ANIMATED_MESH_FEATURES_PACK_OPERATOR(*)
#undef CGAL_ANIMATED_MESH_FEATURES_PACK_OPERATOR

template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<T, n, b> operator*(const Pack<T, n, b>& x, T y)
{
  Pack<T, n, b> result;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < result.registers; ++i) result.r[i] = x.r[i] * y;
  return result;
}

// |x|, by clearing the sign bits.
template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<T, n, b> absolute(const Pack<T, n, b>& x)
{
  typedef std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t> Integer;
  typedef typename Register<Integer, b>::type Bits;
  Pack<T, n, b> result;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < result.registers; ++i) {
    Bits bits;
    std::memcpy(&bits, &x.r[i], b);
    bits &= (std::numeric_limits<Integer>::max)();
    std::memcpy(&result.r[i], &bits, b);
  }
  return result;
}

template <class T, std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<T, n, b> larger(const Pack<T, n, b>& x, const Pack<T, n, b>& y)
{
  Pack<T, n, b> result;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < result.registers; ++i) result.r[i] = x.r[i] > y.r[i] ? x.r[i] : y.r[i];
  return result;
}

// Two packs that go through the same filter, so that each hides the latency of the other.
template <class P>
struct Pack_pair
{
  typedef typename P::Scalar Scalar;
  P p, q;

  static CGAL_ANIMATED_MESH_FEATURES_INLINE Pack_pair all(Scalar value) { return {P::all(value), P::all(value)}; }

  CGAL_ANIMATED_MESH_FEATURES_INLINE friend Pack_pair operator+(const Pack_pair& a, const Pack_pair& b)
  {
    return {a.p + b.p, a.q + b.q};
  }
  CGAL_ANIMATED_MESH_FEATURES_INLINE friend Pack_pair operator-(const Pack_pair& a, const Pack_pair& b)
  {
    return {a.p - b.p, a.q - b.q};
  }
  CGAL_ANIMATED_MESH_FEATURES_INLINE friend Pack_pair operator*(const Pack_pair& a, Scalar b)
  {
    return {a.p * b, a.q * b};
  }
};

// Whether it is a pair of which each half is one register of 64 bytes; there are 32 of them.
template <class T>
struct Is_register_pair : std::false_type
{
};
template <class P>
struct Is_register_pair<Pack_pair<P>> : std::bool_constant<P::registers == 1 && sizeof(P) == 64>
{
};

// The scalar of a pack, or a number's own type.
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

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_PACK_H
