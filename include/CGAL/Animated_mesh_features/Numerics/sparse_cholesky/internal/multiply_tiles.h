// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_MULTIPLY_TILES_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_MULTIPLY_TILES_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Cholesky_panel.h>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Four columns of a tile as they are computed: a register of doubles each, with AVX2.
template <std::size_t register_bytes>
using Tile_column = Pack<double, Cholesky_panel::tile, register_bytes>;

// The product A B^T of matrices in tiles of four rows, column after column, `tiles` tiles of A and one of B:
// sums[t][c] = sum over k < count of a_t[k] b[k][c], in the order of k, so that the bits do not depend on the width of
// the registers nor on how many tiles are computed together. Two are enough to hide the latency of a sum.
template <std::size_t register_bytes, std::size_t tiles>
CGAL_ANIMATED_MESH_FEATURES_INLINE void multiply_tiles(const double* const (&a)[tiles], const double* b,
                                                       std::size_t count,
                                                       Tile_column<register_bytes> (&sums)[tiles][Cholesky_panel::tile])
{
  typedef Tile_column<register_bytes> Column;
  constexpr std::size_t tile = Cholesky_panel::tile;
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (std::size_t t = 0; t < tiles; ++t) {
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t c = 0; c < tile; ++c) sums[t][c] = Column::all(0);
  }
  for (std::size_t k = 0; k < count; ++k) {
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t t = 0; t < tiles; ++t) {
      const Column column = Column::load(a[t] + tile * k);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t c = 0; c < tile; ++c) sums[t][c] = sums[t][c] + column * b[tile * k + c];
    }
  }
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_MULTIPLY_TILES_H
