// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_CONVERT_PACKS_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_CONVERT_PACKS_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

#ifdef CGAL_ANIMATED_MESH_FEATURES_HAS_VECTOR_TYPES
// Half a register of float for a register of double, by the bytes of the latter; 8 bytes are a vector, too.
template <std::size_t double_bytes>
struct Half_register
{
  typedef typename Register<float, double_bytes / 2>::memory_type type;
};
template <>
struct Half_register<16>
{
  typedef float type __attribute__((vector_size(8), aligned(4), may_alias));
};
#endif

// A pack of double from numbers of either type, and back.
template <class P>
CGAL_ANIMATED_MESH_FEATURES_INLINE P load_pack(const double* from)
{
  return P::load(from);
}

template <class P>
CGAL_ANIMATED_MESH_FEATURES_INLINE P load_pack(const float* from)
{
  P result;
  constexpr std::size_t n = P::size / P::registers;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < P::registers; ++i) {
#ifdef CGAL_ANIMATED_MESH_FEATURES_HAS_VECTOR_TYPES
    typedef typename Half_register<sizeof(typename P::Register_type)>::type Half;
    result.r[i] = __builtin_convertvector(*reinterpret_cast<const Half*>(from + i * n), typename P::Register_type);
#else
    result.r[i] = double(from[i * n]);
#endif
  }
  return result;
}

template <std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE void store_pack(const Pack<double, n, b>& x, double* to)
{
  x.store(to);
}

template <std::size_t n, std::size_t b>
CGAL_ANIMATED_MESH_FEATURES_INLINE void store_pack(const Pack<double, n, b>& x, float* to)
{
  typedef Pack<double, n, b> P;
  constexpr std::size_t m = n / P::registers;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t i = 0; i < P::registers; ++i) {
#ifdef CGAL_ANIMATED_MESH_FEATURES_HAS_VECTOR_TYPES
    typedef typename Half_register<b>::type Half;
    *reinterpret_cast<Half*>(to + i * m) = __builtin_convertvector(x.r[i], Half);
#else
    to[i * m] = float(x.r[i]);
#endif
  }
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_CONVERT_PACKS_H
