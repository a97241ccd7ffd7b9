// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_CHOLESKY_FACTOR_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_CHOLESKY_FACTOR_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Aligned_vector.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Front_factorization.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/Symbolic_factorization.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The Cholesky factor L of a symmetric positive definite matrix, in the panels of Symbolic_factorization, by the multifrontal
// method; J. W. H. Liu, The multifrontal method for sparse matrix solution: theory and practice, SIAM Review 34(1), 1992.
// Computed in double, kept as T. No fused products, and no blocks that depend on the caches of the machine: the same
// bits wherever it runs.
template <class T>
class Cholesky_factor
{
  typedef Symbolic_factorization::Index Index;
  typedef Symbolic_factorization::Panel Panel;

public:
  // `diagonal(i)` and `entry(i, k)`, for the k-th of the neighbours of row i, are the entries of the matrix.
  // Throws Numerical_error if it is not positive definite.
  template <class Diagonal, class Entry>
  Cholesky_factor(const Symbolic_factorization& symbolic, const Compressed_rows& neighbours, const Diagonal& diagonal,
                    const Entry& entry, Instruction_set instructions)
    : m_values(symbolic.number_of_values())
  {
    std::vector<Index> local(symbolic.number_of_columns()); // number in the panel of each column of the matrix
    Aligned_vector<double> panel_values;
    // Children's updates are on top of the stack, in postorder. That of their parent is made above them, then moved to
    // where they were.
    Aligned_vector<double> stack(symbolic.stack_size());
    std::vector<std::size_t> starts; // of the updates on the stack
    std::vector<const Panel*> panels;
    std::size_t top = 0;
    for (const Panel& p : symbolic.panels()) {
      panel_values.assign(Symbolic_factorization::size(p), 0.);
      double* values = panel_values.data();
      double* update = stack.data() + top;
      std::fill(update, update + Symbolic_factorization::update_size(p), 0.);
      const Index* rows = symbolic.rows(p);
      for (Index i = 0; i < p.width; ++i) local[p.first + i] = i;
      for (Index i = 0; i < p.height; ++i) local[rows[i]] = p.width + i;
      for (Index c = 0; c < p.width; ++c) {
        const Index v = symbolic.original()[p.first + c];
        *address(p, values, c, c) = diagonal(v);
        const Compressed_rows::Row row = neighbours[v];
        for (std::size_t k = 0; k < row.size(); ++k) {
          const Index i = symbolic.position()[row.begin()[k]];
          if (i > p.first + c) *address(p, values, local[i], c) += entry(v, k);
        }
      }
      const std::size_t first_child = panels.size() - p.children;
      for (std::size_t i = first_child; i < panels.size(); ++i)
        add_update(symbolic, *panels[i], stack.data() + starts[i], local, p, values, update);
      Front_factorization kernel{&p, values, update};
      run_reproducibly<double>(instructions, kernel);
      if (!kernel.positive_definite)
        throw Numerical_error("the Cholesky factorisation failed: the matrix is not positive definite");
      std::copy(panel_values.begin(), panel_values.end(), m_values.begin() + std::ptrdiff_t(p.values));
      const std::size_t start = p.children > 0 ? starts[first_child] : top;
      if (start < top) std::copy(update, update + Symbolic_factorization::update_size(p), stack.data() + start);
      starts.resize(first_child);
      panels.resize(first_child);
      starts.push_back(start);
      panels.push_back(&p);
      top = start + Symbolic_factorization::update_size(p);
    }
  }

  const T* values() const { return m_values.data(); }

private:
  // Entry (row, column) of a panel, both counted from its first column.
  static double* address(const Panel& p, double* values, std::size_t row, std::size_t column)
  {
    constexpr std::size_t tile = Symbolic_factorization::tile;
    if (row < p.width) return values + Symbolic_factorization::triangle_tiles(row / tile) + tile * column + row % tile;
    const std::size_t i = row - p.width;
    return values + Symbolic_factorization::triangle_size(p.width) + i / tile * tile * p.width + tile * column + i % tile;
  }

  static void add_update(const Symbolic_factorization& symbolic, const Panel& child, const double* from,
                         const std::vector<Index>& local, const Panel& p, double* values, double* update)
  {
    const Index* rows = symbolic.rows(child);
    const std::size_t stride = Symbolic_factorization::number_of_tiles(child.height) * Symbolic_factorization::tile;
    const std::size_t to_stride = Symbolic_factorization::number_of_tiles(p.height) * Symbolic_factorization::tile;
    for (std::size_t c = 0; c < child.height; ++c) {
      const double* column = from + c * stride;
      const std::size_t to_column = local[rows[c]];
      if (to_column < p.width)
        for (std::size_t r = c; r < child.height; ++r) *address(p, values, local[rows[r]], to_column) += column[r];
      else {
        double* to = update + (to_column - p.width) * to_stride - p.width;
        for (std::size_t r = c; r < child.height; ++r) to[local[rows[r]]] += column[r];
      }
    }
  }

  Aligned_vector<T> m_values;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_CHOLESKY_FACTOR_H
