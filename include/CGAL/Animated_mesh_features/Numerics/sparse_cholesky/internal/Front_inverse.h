// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_FRONT_INVERSE_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_FRONT_INVERSE_H

#include <CGAL/Animated_mesh_features/Numerics/memory/Aligned_vector.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Cholesky_panel.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/multiply_tiles.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The dense part of a selected inversion, for run_reproducibly(): the rows of the inverse Z that belong to the columns J
// of a panel, in the columns of J and of the rows I below, from the panel L and from Z_II. With X = L_JJ^-1 and
// Y = L_IJ X,
//   Z_JI = -Y^T Z_II,   Z_JJ = X^T X - Z_JI Y.
// All matrices are stored in tiles of four rows, column after column, and those that are not symmetric as their
// transposes, so that all products are those of multiply_tiles().
struct Front_inverse
{
  typedef Cholesky_panel Panel;
  static constexpr std::size_t tile = Panel::tile;

  const Panel* panel = nullptr;
  const double* values = nullptr; // of the panel, as Front_factorization leaves them
  const double* below = nullptr;  // Z_II, height x height, rows filled up to tiles with zeros
  Aligned_vector<double> inverse; // X^T
  Aligned_vector<double> y;       // Y^T
  Aligned_vector<double> front; // Z_JJ, filled up to tiles of columns, and Z_JI; Z_JJ near the diagonal only of leaves

  // What a tile of rows of `front` has: columns of Z_JJ, and of both.
  std::size_t own_columns() const { return Panel::number_of_tiles(panel->width) * tile; }
  std::size_t all_columns() const { return own_columns() + Panel::number_of_tiles(panel->height) * tile; }

  // Entry (row, 0) of the front; those of the row are a tile's length apart.
  const double* row(std::size_t i) const { return front.data() + i / tile * tile * all_columns() + i % tile; }

  void set(const Panel& p, const double* panel_values, const double* z_below)
  {
    panel = &p;
    values = panel_values;
    below = z_below;
    inverse.resize(own_columns() * own_columns());
    y.resize(own_columns() * (all_columns() - own_columns()));
    front.resize(own_columns() * all_columns());
  }

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    const std::size_t triangle = Panel::number_of_tiles(panel->width);
    for (std::size_t j = 0; j < triangle; ++j) {
      if (j > 0) std::fill_n(inverse_tile(j) + tile * tile * (j - 1), tile * tile, 0.); // read with the tile before it
      for (std::size_t m = j; m < triangle; ++m) invert_triangle<register_bytes>(j, m);
    }
    for (std::size_t j = 0; j < triangle; j += 2)
      if (j + 1 < triangle)
        multiply_below<register_bytes, 2>(j);
      else
        multiply_below<register_bytes, 1>(j);
    for (std::size_t j = 0; j < triangle; ++j) {
      const std::size_t end = panel->children > 0 ? triangle : j + 1;
      for (std::size_t i = j; i < end; i += 2)
        if (i + 1 < end)
          multiply_own<register_bytes, 2>(i, j);
        else
          multiply_own<register_bytes, 1>(i, j);
    }
  }

private:
  CGAL_ANIMATED_MESH_FEATURES_INLINE double* inverse_tile(std::size_t j) { return &inverse[j * tile * own_columns()]; }
  CGAL_ANIMATED_MESH_FEATURES_INLINE double* front_tile(std::size_t j) { return &front[j * tile * all_columns()]; }
  CGAL_ANIMATED_MESH_FEATURES_INLINE double* y_tile(std::size_t j)
  {
    return y.data() + j * tile * (all_columns() - own_columns());
  }

  // The columns of tile m in the rows of tile j of X^T: X is what the triangle makes of the identity.
  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void invert_triangle(std::size_t j, std::size_t m)
  {
    typedef Tile_column<register_bytes> Column;
    static constexpr double identity[2][tile * tile] = {{}, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    const std::size_t columns = (std::min)(tile, panel->width - tile * m);
    const double* l = values + Panel::triangle_tiles(m);
    const double* const x[1] = {inverse_tile(j) + tile * tile * j};
    Column sums[1][tile];
    multiply_tiles<register_bytes, 1>(x, l + tile * tile * j, tile * (m - j), sums);
    l += tile * tile * m;
    double* const to = inverse_tile(j) + tile * tile * m;
    for (std::size_t c = 0; c < columns; ++c) {
      Column column = Column::load(identity[j == m] + tile * c) - sums[0][c];
      for (std::size_t k = 0; k < c; ++k) column = column - Column::load(to + tile * k) * l[tile * k + c];
      (column * l[tile * c + c]).store(to + tile * c); // its reciprocal, there
    }
  }

  // Y^T, then Z_JI, in `tiles` tiles of rows from the j-th on.
  template <std::size_t register_bytes, std::size_t tiles>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void multiply_below(std::size_t j)
  {
    typedef Tile_column<register_bytes> Column;
    const std::size_t width = panel->width, height = panel->height, height_tiles = Panel::number_of_tiles(height);
    const double* x[tiles];
    double *to_y[tiles], *to_z[tiles];
    for (std::size_t t = 0; t < tiles; ++t) {
      x[t] = inverse_tile(j + t) + tile * tile * j;
      to_y[t] = y_tile(j + t);
      to_z[t] = front_tile(j + t) + tile * own_columns();
    }
    const double* l = values + Panel::triangle_size(width) + tile * tile * j;
    Column sums[tiles][tile];
    for (std::size_t i = 0; i < height_tiles; ++i) {
      multiply_tiles<register_bytes, tiles>(x, l + i * tile * width, width - tile * j, sums);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t t = 0; t < tiles; ++t) {
        CGAL_ANIMATED_MESH_FEATURES_UNROLL
        for (std::size_t c = 0; c < tile; ++c) sums[t][c].store(to_y[t] + tile * (tile * i + c));
      }
    }
    const double* y_of[tiles];
    for (std::size_t t = 0; t < tiles; ++t) y_of[t] = to_y[t];
    for (std::size_t i = 0; i < height_tiles; ++i) {
      multiply_tiles<register_bytes, tiles>(y_of, below + i * tile * height, height, sums);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t t = 0; t < tiles; ++t) {
        CGAL_ANIMATED_MESH_FEATURES_UNROLL
        for (std::size_t c = 0; c < tile; ++c) (Column::all(0) - sums[t][c]).store(to_z[t] + tile * (tile * i + c));
      }
    }
  }

  // Z_JJ in `tiles` tiles of rows from the i-th on and the columns of tile j, and in the rows of these columns.
  template <std::size_t register_bytes, std::size_t tiles>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void multiply_own(std::size_t i, std::size_t j)
  {
    typedef Tile_column<register_bytes> Column;
    const double *x[tiles], *y_of[tiles];
    for (std::size_t t = 0; t < tiles; ++t) {
      x[t] = inverse_tile(i + t) + tile * tile * i;
      y_of[t] = y_tile(i + t);
    }
    Column sums[tiles][tile], sums_below[tiles][tile];
    multiply_tiles<register_bytes, tiles>(x, inverse_tile(j) + tile * tile * i, panel->width - tile * i, sums);
    multiply_tiles<register_bytes, tiles>(y_of, front_tile(j) + tile * own_columns(), panel->height, sums_below);
    for (std::size_t t = 0; t < tiles; ++t)
      for (std::size_t c = 0; c < tile; ++c) {
        double* to = front_tile(i + t) + tile * (tile * j + c);
        (sums[t][c] - sums_below[t][c]).store(to);
        for (std::size_t r = 0; r < tile; ++r) front_tile(j)[tile * (tile * (i + t) + r) + c] = to[r];
      }
  }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_FRONT_INVERSE_H
