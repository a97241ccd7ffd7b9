// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_PACKED_VECTOR_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_PACKED_VECTOR_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/convert_packs.h>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Three-dimensional vectors, one for each entry of a pack.
template <class L>
struct Packed_vector
{
  L x, y, z;

  // Of row v, where x, y and z of `rows` are those of row 0 and others follow by `stride`.
  template <class Rows>
  static CGAL_ANIMATED_MESH_FEATURES_INLINE Packed_vector load(const Rows& rows, std::size_t v)
  {
    const std::size_t first = v * rows.stride;
    return {load(rows.x + first), load(rows.y + first), load(rows.z + first)};
  }

  CGAL_ANIMATED_MESH_FEATURES_INLINE L dot(const Packed_vector& b) const { return x * b.x + y * b.y + z * b.z; }

  CGAL_ANIMATED_MESH_FEATURES_INLINE Packed_vector cross(const Packed_vector& b) const
  {
    return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
  }

  friend CGAL_ANIMATED_MESH_FEATURES_INLINE Packed_vector operator+(const Packed_vector& a, const Packed_vector& b)
  {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }

  friend CGAL_ANIMATED_MESH_FEATURES_INLINE Packed_vector operator-(const Packed_vector& a, const Packed_vector& b)
  {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }

  friend CGAL_ANIMATED_MESH_FEATURES_INLINE Packed_vector operator*(const Packed_vector& a, typename L::Scalar s)
  {
    return {a.x * s, a.y * s, a.z * s};
  }

  friend CGAL_ANIMATED_MESH_FEATURES_INLINE Packed_vector operator*(const Packed_vector& a, const L& s)
  {
    return {a.x * s, a.y * s, a.z * s};
  }

private:
  static CGAL_ANIMATED_MESH_FEATURES_INLINE L load(const typename L::Scalar* from) { return L::load(from); }

  // numbers of the other type are converted
  template <class T>
  static CGAL_ANIMATED_MESH_FEATURES_INLINE L load(const T* from)
  {
    return load_pack<L>(from);
  }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_PACKED_VECTOR_H
