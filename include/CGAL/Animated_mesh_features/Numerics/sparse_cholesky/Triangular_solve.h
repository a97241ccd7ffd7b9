// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_TRIANGULAR_SOLVE_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_TRIANGULAR_SOLVE_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/Symbolic_factorization.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The triangular solves of a factor, in place, for many right-hand sides at a time, for run_reproducibly(). Those of a
// cache line are computed with together: four rows of them are held in registers, and each entry of the factor that is
// loaded serves all of them. Several cache lines take turns at each panel, while it is in the L1 cache.
template <class T>
struct Triangular_solve
{
  static constexpr std::size_t tile = Symbolic_factorization::tile;
  static constexpr std::size_t lanes = 64 / sizeof(T);

  const Symbolic_factorization* symbolic;
  const T* values;   // of the factor
  T* x;              // [line][row in the order of the factor, and one more][lane]
  std::size_t lines; // of right-hand sides

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    typedef Pack<T, lanes, register_bytes> L;
    const std::vector<Symbolic_factorization::Panel>& panels = symbolic->panels();
    const std::size_t size = (symbolic->number_of_columns() + 1) * lanes;
    for (const Symbolic_factorization::Panel& p : panels)
      for (std::size_t line = 0; line < lines; ++line) forward<L>(p, x + line * size);
    for (std::size_t i = panels.size(); i-- > 0;)
      for (std::size_t line = 0; line < lines; ++line) backward<L>(panels[i], x + line * size);
  }

private:
  // sums[i] += sum over k < count of l[k][i] x_k
  template <class L>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void multiply(const T* l, const T* x_k, std::size_t count, L (&sums)[tile]) const
  {
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 0; i < tile; ++i) sums[i] = L::all(0);
    for (std::size_t k = 0; k < count; ++k) {
      const L row = L::load(x_k + k * lanes);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t i = 0; i < tile; ++i) sums[i] = sums[i] + row * l[tile * k + i];
    }
  }

  template <class L>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void forward(const Symbolic_factorization::Panel& p, T* to) const
  {
    const std::size_t width = p.width;
    const T* l = values + p.values;
    T* own = to + p.first * lanes;
    std::size_t j = 0;
    for (; j + tile <= width; j += tile) l = forward_rows<L, tile>(l, own, j);
    switch (width - j) {
    case 1:
      l = forward_rows<L, 1>(l, own, j);
      break;
    case 2:
      l = forward_rows<L, 2>(l, own, j);
      break;
    case 3:
      l = forward_rows<L, 3>(l, own, j);
      break;
    default:
      break;
    }
    const Symbolic_factorization::Index* rows = symbolic->rows(p);
    const std::size_t below = Symbolic_factorization::number_of_tiles(p.height);
    for (std::size_t i = 0; i < below; ++i, l += tile * width, rows += tile) {
      L sums[tile];
      multiply(l, own, width, sums);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t r = 0; r < tile; ++r) {
        T* row = to + rows[r] * lanes;
        (L::load(row) - sums[r]).store(row);
      }
    }
  }

  // Rows [j, j + rows) of the panel's own, those before them being solved. Returns where the next tile is.
  template <class L, std::size_t rows>
  CGAL_ANIMATED_MESH_FEATURES_INLINE const T* forward_rows(const T* l, T* own, std::size_t j) const
  {
    L sums[tile];
    multiply(l, own, j, sums);
    l += tile * j;
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t r = 0; r < rows; ++r) {
      sums[r] = (L::load(own + (j + r) * lanes) - sums[r]) * l[tile * r + r];
      sums[r].store(own + (j + r) * lanes);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t s = r + 1; s < rows; ++s) sums[s] = sums[s] + sums[r] * l[tile * r + s];
    }
    return l + tile * rows;
  }

  template <class L>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void backward(const Symbolic_factorization::Panel& p, T* to) const
  {
    std::size_t j = (p.width - 1) / tile * tile;
    switch (p.width - j) {
    case 1:
      backward_columns<L, 1>(p, to, j);
      break;
    case 2:
      backward_columns<L, 2>(p, to, j);
      break;
    case 3:
      backward_columns<L, 3>(p, to, j);
      break;
    default:
      backward_columns<L, 4>(p, to, j);
    }
    for (; j > 0; j -= tile) backward_columns<L, 4>(p, to, j - tile);
  }

  // Columns [j, j + columns) of the panel, those behind them being solved.
  template <class L, std::size_t columns>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void backward_columns(const Symbolic_factorization::Panel& p, T* to, std::size_t j) const
  {
    const std::size_t width = p.width;
    T* own = to + p.first * lanes;
    L sums[columns];
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t c = 0; c < columns; ++c) sums[c] = L::all(0);
    const auto add = [&](const T* l, const T* row) CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA {
      const L x_r = L::load(row);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t c = 0; c < columns; ++c) sums[c] = sums[c] + x_r * l[tile * c];
    };
    const T* triangle = values + p.values;
    for (std::size_t i = j + tile; i < width; i += tile) {
      const T* l = triangle + Symbolic_factorization::triangle_tiles(i / tile) + tile * j;
      for (std::size_t r = 0; r < (std::min)(tile, width - i); ++r) add(l + r, own + (i + r) * lanes);
    }
    const T* l = triangle + Symbolic_factorization::triangle_size(width) + tile * j;
    const Symbolic_factorization::Index* rows = symbolic->rows(p);
    const std::size_t below = Symbolic_factorization::number_of_tiles(p.height);
    for (std::size_t i = 0; i < below; ++i, l += tile * width, rows += tile) {
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t r = 0; r < tile; ++r) add(l + r, to + rows[r] * lanes);
    }
    l = triangle + Symbolic_factorization::triangle_tiles(j / tile) + tile * j;
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t c = columns - 1 - i;
      const L x_c = (L::load(own + (j + c) * lanes) - sums[c]) * l[tile * c + c];
      x_c.store(own + (j + c) * lanes);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t k = 0; k < c; ++k) sums[k] = sums[k] + x_c * l[tile * k + c];
    }
  }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_TRIANGULAR_SOLVE_H
