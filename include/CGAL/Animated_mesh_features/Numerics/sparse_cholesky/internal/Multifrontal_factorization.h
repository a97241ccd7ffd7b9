// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_MULTIFRONTAL_FACTORIZATION_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_MULTIFRONTAL_FACTORIZATION_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Aligned_vector.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Front_factorization.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Symbolic_factorization.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Computes the values of a Cholesky factor, panel by panel, by the multifrontal method; J. W. H. Liu, The multifrontal
// method for sparse matrix solution: theory and practice, SIAM Review 34(1), 1992. In double, whatever the factor is
// kept in. No fused products, and no blocks that depend on the caches of the machine: the same bits wherever it runs.
class Multifrontal_factorization
{
  typedef Symbolic_factorization::Index Index;
  typedef Symbolic_factorization::Panel Panel;

public:
  Multifrontal_factorization(const Symbolic_factorization& symbolic, const Compressed_rows& neighbours,
                             Instruction_set instructions)
    : m_symbolic(symbolic)
    , m_neighbours(neighbours)
    , m_instructions(instructions)
    , m_local(symbolic.number_of_columns())
    , m_stack(symbolic.stack_size())
  {}

  // `diagonal(i)` and `entry(i, k)`, for the k-th of the neighbours of row i, are the entries of the matrix. The values
  // of the factor go to `factor`. Throws Numerical_error if the matrix is not positive definite.
  template <class Diagonal, class Entry, class T>
  void run(const Diagonal& diagonal, const Entry& entry, T* factor)
  {
    m_top = 0;
    m_waiting.clear();
    for (const Panel& p : m_symbolic.panels()) {
      cancellation_point();
      begin(p);
      load(p, diagonal, entry);
      const std::size_t first_child = m_waiting.size() - p.children;
      for (std::size_t i = first_child; i < m_waiting.size(); ++i) add_update(m_waiting[i], p);
      Front_factorization front{&p, m_values.data(), m_update};
      run_reproducibly<double>(m_instructions, front);
      if (!front.positive_definite)
        throw Numerical_error("the Cholesky factorisation failed: the matrix is not positive definite");
      std::copy(m_values.begin(), m_values.end(), factor + p.values);
      pass_on(p, first_child);
    }
  }

private:
  // What a panel left for the rows below it, on the stack until their panel comes.
  struct Update
  {
    const Panel* panel;
    std::size_t start;
  };

  // The panel and its update, empty. The updates of its children are on top of the stack, in postorder; its own is made
  // above them.
  void begin(const Panel& p)
  {
    m_values.assign(p.size(), 0.);
    m_update = m_stack.data() + m_top;
    std::fill(m_update, m_update + p.update_size(), 0.);
    const Index* rows = m_symbolic.rows(p);
    for (Index i = 0; i < p.width; ++i) m_local[p.first + i] = i;
    for (Index i = 0; i < p.height; ++i) m_local[rows[i]] = p.width + i;
  }

  // Adds the entries of the matrix.
  template <class Diagonal, class Entry>
  void load(const Panel& p, const Diagonal& diagonal, const Entry& entry)
  {
    double* const values = m_values.data();
    for (Index c = 0; c < p.width; ++c) {
      const Index v = m_symbolic.original()[p.first + c];
      *address(p, values, c, c) = diagonal(v);
      const Compressed_rows::Row row = m_neighbours[v];
      for (std::size_t k = 0; k < row.size(); ++k) {
        const Index i = m_symbolic.position()[row.begin()[k]];
        if (i > p.first + c) *address(p, values, m_local[i], c) += entry(v, k);
      }
    }
  }

  // Adds what a child left.
  void add_update(const Update& child, const Panel& p)
  {
    const std::size_t height = child.panel->height;
    const Index* const rows = m_symbolic.rows(*child.panel);
    const Index* const local = m_local.data();
    const std::size_t stride = Panel::number_of_tiles(height) * Panel::tile;
    const std::size_t to_stride = Panel::number_of_tiles(p.height) * Panel::tile;
    double *const values = m_values.data(), *const update = m_update;
    for (std::size_t c = 0; c < height; ++c) {
      const double* column = m_stack.data() + child.start + c * stride;
      const std::size_t to_column = local[rows[c]];
      if (to_column < p.width)
        for (std::size_t r = c; r < height; ++r) *address(p, values, local[rows[r]], to_column) += column[r];
      else {
        double* to = update + (to_column - p.width) * to_stride - p.width;
        for (std::size_t r = c; r < height; ++r) to[local[rows[r]]] += column[r];
      }
    }
  }

  // Moves the panel's update to where those of its children were.
  void pass_on(const Panel& p, std::size_t first_child)
  {
    const std::size_t start = p.children > 0 ? m_waiting[first_child].start : m_top;
    if (start < m_top) std::copy(m_update, m_update + p.update_size(), m_stack.data() + start);
    m_waiting.resize(first_child);
    m_waiting.push_back({&p, start});
    m_top = start + p.update_size();
  }

  // Entry (row, column) of a panel, both counted from its first column.
  static double* address(const Panel& p, double* values, std::size_t row, std::size_t column)
  {
    constexpr std::size_t tile = Panel::tile;
    if (row < p.width) return values + Panel::triangle_tiles(row / tile) + tile * column + row % tile;
    const std::size_t i = row - p.width;
    return values + Panel::triangle_size(p.width) + i / tile * tile * p.width + tile * column + i % tile;
  }

  const Symbolic_factorization& m_symbolic;
  const Compressed_rows& m_neighbours;
  Instruction_set m_instructions;
  std::vector<Index> m_local; // number in the panel of each row of the factor that it has
  Aligned_vector<double> m_values;
  double* m_update = nullptr;
  Aligned_vector<double> m_stack;
  std::size_t m_top = 0; // of the stack
  std::vector<Update> m_waiting;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_MULTIFRONTAL_FACTORIZATION_H
