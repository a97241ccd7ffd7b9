// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_CHOLESKY_PANEL_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_CHOLESKY_PANEL_H

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A run of columns of a factor that share the rows below them, so that all arithmetic is on small dense matrices. It is
// stored in tiles of four rows, column after column: first those of its own columns, a triangle, then those of the rows
// below, filled up with rows that do not exist.
struct Cholesky_panel
{
  typedef std::uint32_t Index;

  // Rows of a tile: a register of doubles with AVX2.
  static constexpr std::size_t tile = 4;

  // Columns at most: 64 columns of a tile are 2 KiB, so that two tiles and what they are multiplied with stay in the L1
  // cache, while wide fronts are still worked off by products of matrices.
  static constexpr std::size_t widest = 64;

  Index first;        // column
  Index width;        // columns
  Index height;       // rows below
  Index children;     // panels whose parent this is; they come right before it, in postorder
  std::size_t rows;   // where its rows are, among those of all panels
  std::size_t values; // where its values are, in those of a factor

  static std::size_t number_of_tiles(std::size_t rows) { return (rows + tile - 1) / tile; }

  // Numbers in all tiles of the triangle before the i-th, of which the last one has the panel's width only.
  static std::size_t triangle_tiles(std::size_t i) { return tile * tile * i * (i + 1) / 2; }
  static std::size_t triangle_size(std::size_t width)
  {
    return triangle_tiles(number_of_tiles(width) - 1) + tile * width;
  }

  // Numbers in the panel.
  std::size_t size() const { return triangle_size(width) + number_of_tiles(height) * tile * width; }

  // Numbers in what it passes on to its parent: the lower triangle of a square matrix, stored with its upper one.
  std::size_t update_size() const { return number_of_tiles(height) * tile * height; }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_CHOLESKY_PANEL_H
