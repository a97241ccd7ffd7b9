// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_FRONT_FACTORIZATION_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_FRONT_FACTORIZATION_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Cholesky_panel.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/multiply_tiles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The dense part of a factorisation, for run_reproducibly(): the Cholesky factor L of a panel, in place, and what its
// columns leave for the rows below, U -= L L^T. Products are subtracted from an entry in the order of the columns, so
// that the bits do not depend on the width of the registers.
struct Front_factorization
{
  typedef Cholesky_panel Panel;
  static constexpr std::size_t tile = Panel::tile;

  const Panel* panel;
  double* values; // as Cholesky_panel has them; the diagonal is replaced by its reciprocals
  double* update; // the columns of a square matrix, from the diagonal's tile on; rows filled up to tiles
  bool positive_definite = true;

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    const std::size_t width = panel->width, triangle = Panel::number_of_tiles(width);
    const std::size_t below = Panel::number_of_tiles(panel->height);
    for (std::size_t j = 0; j < triangle; ++j) {
      const std::size_t columns = (std::min)(tile, width - tile * j);
      for (std::size_t i = j; i < triangle + below; i += 2) {
        const bool two = i + 1 < triangle + below;
        if (two)
          reduce_columns<register_bytes, 2>(i, j, columns);
        else
          reduce_columns<register_bytes, 1>(i, j, columns);
        if (i == j) factor_diagonal(j, columns);
        if (i > j) divide_columns(i, j, columns);
        if (two) divide_columns(i + 1, j, columns);
      }
    }
    for (std::size_t j = 0; j < below; ++j)
      for (std::size_t i = j; i < below; i += 2)
        if (i + 1 < below)
          reduce_update<register_bytes, 2>(i, j);
        else
          reduce_update<register_bytes, 1>(i, j);
  }

private:
  CGAL_ANIMATED_MESH_FEATURES_INLINE double* tile_of_rows(std::size_t i) const
  {
    const std::size_t triangle = Panel::number_of_tiles(panel->width);
    if (i < triangle) return values + Panel::triangle_tiles(i);
    return values + Panel::triangle_size(panel->width) + (i - triangle) * tile * panel->width;
  }

  // What the columns before those of tile j take from them, in `tiles` tiles from the i-th on.
  template <std::size_t register_bytes, std::size_t tiles>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void reduce_columns(std::size_t i, std::size_t j, std::size_t columns)
  {
    typedef Tile_column<register_bytes> Column;
    double* a[tiles];
    const double* read[tiles];
    for (std::size_t t = 0; t < tiles; ++t) read[t] = a[t] = tile_of_rows(i + t);
    Column sums[tiles][tile];
    multiply_tiles<register_bytes, tiles>(read, tile_of_rows(j), tile * j, sums);
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t t = 0; t < tiles; ++t) {
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t c = 0; c < tile; ++c) {
        double* to = a[t] + tile * (tile * j + c);
        if (c < columns) (Column::load(to) - sums[t][c]).store(to);
      }
    }
  }

  CGAL_ANIMATED_MESH_FEATURES_INLINE void factor_diagonal(std::size_t j, std::size_t columns)
  {
    double* a = tile_of_rows(j) + tile * tile * j; // [column][row]
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t k = 0; k < c; ++k)
        for (std::size_t r = c; r < columns; ++r) a[tile * c + r] -= a[tile * k + r] * a[tile * k + c];
      const double pivot = a[tile * c + c];
      if (!(pivot > 0)) positive_definite = false;
      const double reciprocal = 1 / std::sqrt(pivot);
      a[tile * c + c] = reciprocal;
      for (std::size_t r = c + 1; r < columns; ++r) a[tile * c + r] *= reciprocal;
      for (std::size_t r = 0; r < c; ++r) a[tile * c + r] = 0;
    }
  }

  // The columns of tile j in the i-th tile of rows, by the triangle on the diagonal.
  CGAL_ANIMATED_MESH_FEATURES_INLINE void divide_columns(std::size_t i, std::size_t j, std::size_t columns)
  {
    const double* l = tile_of_rows(j) + tile * tile * j;
    double* a = tile_of_rows(i) + tile * tile * j;
    for (std::size_t c = 0; c < columns; ++c)
      for (std::size_t r = 0; r < tile; ++r) {
        double x = a[tile * c + r];
        for (std::size_t k = 0; k < c; ++k) x -= a[tile * k + r] * l[tile * k + c];
        a[tile * c + r] = x * l[tile * c + c];
      }
  }

  template <std::size_t register_bytes, std::size_t tiles>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void reduce_update(std::size_t i, std::size_t j)
  {
    typedef Tile_column<register_bytes> Column;
    const std::size_t triangle = Panel::number_of_tiles(panel->width);
    const std::size_t stride = Panel::number_of_tiles(panel->height) * tile;
    const std::size_t columns = (std::min)(tile, panel->height - tile * j);
    const double* a[tiles];
    for (std::size_t t = 0; t < tiles; ++t) a[t] = tile_of_rows(triangle + i + t);
    Column sums[tiles][tile];
    multiply_tiles<register_bytes, tiles>(a, tile_of_rows(triangle + j), panel->width, sums);
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t t = 0; t < tiles; ++t) {
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t c = 0; c < tile; ++c) {
        double* to = update + (tile * j + c) * stride + tile * (i + t);
        if (c < columns) (Column::load(to) - sums[t][c]).store(to);
      }
    }
  }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_FRONT_FACTORIZATION_H
