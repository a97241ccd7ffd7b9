// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_TRIANGULAR_SOLVE_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_TRIANGULAR_SOLVE_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Symbolic_factorization.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The triangular solves of a factor, in place, for many right-hand sides at a time, for run_reproducibly(). They come
// in packs of a cache line, of which four rows are held in registers: each entry of the factor that is loaded serves a
// whole pack. Several packs take turns at each panel, while it is in the L1 cache.
template <class T>
struct Triangular_solve
{
  typedef Cholesky_panel Panel;
  static constexpr std::size_t tile = Panel::tile;
  static constexpr std::size_t pack_size = 64 / sizeof(T);

  const Symbolic_factorization* symbolic;
  const T* values;   // of the factor
  T* x;              // [pack][row in the order of the factor, and one more][entry of the pack]
  std::size_t packs; // of right-hand sides

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    typedef Pack<T, pack_size, register_bytes> Row_pack;
    const std::vector<Panel>& panels = symbolic->panels();
    const std::size_t size = (symbolic->number_of_columns() + 1) * pack_size;
    constexpr std::size_t often = 1024; // small panels take less than a microsecond
    for (std::size_t i = 0; i < panels.size(); ++i) {
      if (i % often == 0) cancellation_point();
      for (std::size_t pack = 0; pack < packs; ++pack) forward<Row_pack>(panels[i], x + pack * size);
    }
    for (std::size_t i = panels.size(); i-- > 0;) {
      if (i % often == 0) cancellation_point();
      for (std::size_t pack = 0; pack < packs; ++pack) backward<Row_pack>(panels[i], x + pack * size);
    }
  }

private:
  // sums[i] = sum over k < count of l[k][i] x_k
  template <class Row_pack>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void multiply(const T* l, const T* x_k, std::size_t count,
                                                   Row_pack (&sums)[tile]) const
  {
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 0; i < tile; ++i) sums[i] = Row_pack::all(0);
    for (std::size_t k = 0; k < count; ++k) {
      const Row_pack row = Row_pack::load(x_k + k * pack_size);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t i = 0; i < tile; ++i) sums[i] = sums[i] + row * l[tile * k + i];
    }
  }

  template <class Row_pack>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void forward(const Panel& p, T* to) const
  {
    const std::size_t width = p.width;
    const T* l = values + p.values;
    T* own = to + p.first * pack_size;
    std::size_t j = 0;
    for (; j + tile <= width; j += tile) l = forward_rows<Row_pack, tile>(l, own, j);
    switch (width - j) {
    case 1:
      l = forward_rows<Row_pack, 1>(l, own, j);
      break;
    case 2:
      l = forward_rows<Row_pack, 2>(l, own, j);
      break;
    case 3:
      l = forward_rows<Row_pack, 3>(l, own, j);
      break;
    default:
      break;
    }
    const Symbolic_factorization::Index* rows = symbolic->rows(p);
    const std::size_t below = Panel::number_of_tiles(p.height);
    for (std::size_t i = 0; i < below; ++i, l += tile * width, rows += tile) {
      Row_pack sums[tile];
      multiply(l, own, width, sums);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t r = 0; r < tile; ++r) {
        T* row = to + rows[r] * pack_size;
        (Row_pack::load(row) - sums[r]).store(row);
      }
    }
  }

  // Rows [j, j + rows) of the panel's own, those before them being solved. Returns where the next tile is.
  template <class Row_pack, std::size_t rows>
  CGAL_ANIMATED_MESH_FEATURES_INLINE const T* forward_rows(const T* l, T* own, std::size_t j) const
  {
    Row_pack sums[tile];
    multiply(l, own, j, sums);
    l += tile * j;
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t r = 0; r < rows; ++r) {
      sums[r] = (Row_pack::load(own + (j + r) * pack_size) - sums[r]) * l[tile * r + r];
      sums[r].store(own + (j + r) * pack_size);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t s = r + 1; s < rows; ++s) sums[s] = sums[s] + sums[r] * l[tile * r + s];
    }
    return l + tile * rows;
  }

  template <class Row_pack>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void backward(const Panel& p, T* to) const
  {
    std::size_t j = (p.width - 1) / tile * tile;
    switch (p.width - j) {
    case 1:
      backward_columns<Row_pack, 1>(p, to, j);
      break;
    case 2:
      backward_columns<Row_pack, 2>(p, to, j);
      break;
    case 3:
      backward_columns<Row_pack, 3>(p, to, j);
      break;
    default:
      backward_columns<Row_pack, 4>(p, to, j);
    }
    for (; j > 0; j -= tile) backward_columns<Row_pack, 4>(p, to, j - tile);
  }

  // Columns [j, j + columns) of the panel, those after them being solved.
  template <class Row_pack, std::size_t columns>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void backward_columns(const Panel& p, T* to, std::size_t j) const
  {
    const std::size_t width = p.width;
    T* own = to + p.first * pack_size;
    Row_pack sums[columns];
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t c = 0; c < columns; ++c) sums[c] = Row_pack::all(0);
    const auto add = [&](const T* l, const T* row) CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA {
      const Row_pack x_r = Row_pack::load(row);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t c = 0; c < columns; ++c) sums[c] = sums[c] + x_r * l[tile * c];
    };
    const T* triangle = values + p.values;
    for (std::size_t i = j + tile; i < width; i += tile) {
      const T* l = triangle + Panel::triangle_tiles(i / tile) + tile * j;
      for (std::size_t r = 0; r < (std::min)(tile, width - i); ++r) add(l + r, own + (i + r) * pack_size);
    }
    const T* l = triangle + Panel::triangle_size(width) + tile * j;
    const Symbolic_factorization::Index* rows = symbolic->rows(p);
    const std::size_t below = Panel::number_of_tiles(p.height);
    for (std::size_t i = 0; i < below; ++i, l += tile * width, rows += tile) {
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t r = 0; r < tile; ++r) add(l + r, to + rows[r] * pack_size);
    }
    l = triangle + Panel::triangle_tiles(j / tile) + tile * j;
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t c = columns - 1 - i;
      const Row_pack x_c = (Row_pack::load(own + (j + c) * pack_size) - sums[c]) * l[tile * c + c];
      x_c.store(own + (j + c) * pack_size);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t k = 0; k < c; ++k) sums[k] = sums[k] + x_c * l[tile * k + c];
    }
  }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_TRIANGULAR_SOLVE_H
