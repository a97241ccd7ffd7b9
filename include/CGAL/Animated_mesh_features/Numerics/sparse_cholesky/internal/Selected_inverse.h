// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_SELECTED_INVERSE_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_SELECTED_INVERSE_H

#include <CGAL/Animated_mesh_features/Numerics/memory/Aligned_vector.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Front_inverse.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Symbolic_factorization.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Entries of the inverse Z = A^-1 of a matrix from its Cholesky factor L, without the inverse as a whole: those where L
// has entries can be had from one another. K. Takahashi, J. Fagan, M.-S. Chin, Formation of a sparse bus impedance
// matrix and its application to short circuit study (PICA Conference, 1973); A. M. Erisman, W. F. Tinney, On computing
// certain elements of the inverse of a sparse matrix (Communications of the ACM 18(3), 1975).
//
// From Z L = L^-T follows, for the columns J of a panel and the rows I below them, what Front_inverse computes from Z_II;
// and since all of I are rows of the panel's parent, Z_II is a part of what was computed there. So panels are worked off
// from the last to the first, as in the multifrontal factorisation but backwards: what is taken out of a parent waits on
// a stack for its children, and the stack is as high as it was for the factorisation.
class Selected_inverse
{
  typedef Symbolic_factorization::Index Index;
  typedef Symbolic_factorization::Panel Panel;

public:
  Selected_inverse(const Symbolic_factorization& symbolic, Instruction_set instructions)
    : m_symbolic(symbolic)
    , m_instructions(instructions)
    , m_local(symbolic.number_of_columns())
    , m_stack(symbolic.stack_size())
  {
    find_children();
  }

  // The diagonal of the inverse, numbered as the matrix is, from the values of a factor.
  template <class T>
  std::vector<double> diagonal(const T* factor)
  {
    std::vector<double> result(m_symbolic.number_of_columns());
    const std::vector<Panel>& panels = m_symbolic.panels();
    m_top = 0;
    for (std::size_t i = panels.size(); i-- > 0;) {
      cancellation_point();
      const Panel& p = panels[i];
      m_top -= p.update_size();
      m_front.set(p, in_double(factor + p.values, p.size()), m_stack.data() + m_top);
      run_reproducibly<double>(m_instructions, m_front);
      for (Index c = 0; c < p.width; ++c) result[m_symbolic.original()[p.first + c]] = m_front.row(c)[Panel::tile * c];
      pass_on(i);
    }
    return result;
  }

private:
  static const double* in_double(const double* values, std::size_t) { return values; }
  const double* in_double(const float* values, std::size_t size)
  {
    m_values.assign(values, values + size);
    return m_values.data();
  }

  // The children of each panel, in postorder.
  void find_children()
  {
    const std::vector<Panel>& panels = m_symbolic.panels();
    std::vector<Index> waiting;
    m_children.reserve(panels.size());
    m_first_child.reserve(panels.size());
    for (std::size_t i = 0; i < panels.size(); ++i) {
      m_first_child.push_back(m_children.size());
      m_children.insert(m_children.end(), waiting.end() - panels[i].children, waiting.end());
      waiting.resize(waiting.size() - panels[i].children);
      waiting.push_back(Index(i));
    }
  }

  // Replaces Z_II of panel i on the stack by those of its children, the last one, which comes next, on top.
  void pass_on(std::size_t i)
  {
    const Panel& p = m_symbolic.panels()[i];
    if (p.children == 0) return;
    const Index own = Index(m_front.own_columns()), *const rows = m_symbolic.rows(p);
    for (Index c = 0; c < p.width; ++c) m_local[p.first + c] = c;
    for (Index r = 0; r < p.height; ++r) m_local[rows[r]] = own + r;
    const std::size_t start = m_top + p.update_size();
    std::size_t end = start;
    for (Index c = 0; c < p.children; ++c) {
      const Panel& child = m_symbolic.panels()[m_children[m_first_child[i] + c]];
      gather(child, m_stack.data() + end);
      end += child.update_size();
    }
    if (start > m_top) std::copy(m_stack.data() + start, m_stack.data() + end, m_stack.data() + m_top);
    m_top += end - start;
  }

  // Z_II of a child of the panel at hand, whose rows are numbered in m_local.
  void gather(const Panel& child, double* to)
  {
    constexpr std::size_t tile = Panel::tile;
    const std::size_t height = child.height, own = m_front.own_columns();
    const Index* const rows = m_symbolic.rows(child);
    m_columns.resize(height);
    for (std::size_t c = 0; c < height; ++c) m_columns[c] = m_local[rows[c]];
    const Index* const columns = m_columns.data();
    const std::size_t in_panel = std::size_t(std::lower_bound(columns, columns + height, Index(own)) - columns);
    const auto row_of = [&](std::size_t r) { return to + r / tile * tile * height + r % tile; };
    for (std::size_t r = 0; r < in_panel; ++r) {
      const double* const from = m_front.row(columns[r]);
      double* const row = row_of(r);
      for (std::size_t c = 0; c < height; ++c) row[tile * c] = from[tile * columns[c]];
      for (std::size_t c = in_panel; c < height; ++c) row_of(c)[tile * r] = row[tile * c];
    }
    const double* const below = m_front.below;
    for (std::size_t r = in_panel; r < height; ++r) {
      const std::size_t i = columns[r] - own;
      const double* const from = below + i / tile * tile * m_front.panel->height + i % tile;
      double* const row = row_of(r);
      for (std::size_t c = in_panel; c < height; ++c) row[tile * c] = from[tile * (columns[c] - own)];
    }
    for (std::size_t r = height; r % tile != 0; ++r)
      for (std::size_t c = 0; c < height; ++c) row_of(r)[tile * c] = 0;
  }

  const Symbolic_factorization& m_symbolic;
  Instruction_set m_instructions;
  std::vector<Index> m_children;          // of all panels
  std::vector<std::size_t> m_first_child; // of each panel, among them
  std::vector<Index> m_local;             // column in the front of each row of the factor that the panel has
  std::vector<Index> m_columns;           // the same for the rows of a child
  Aligned_vector<double> m_values;        // of a panel, if the factor is not in double
  Front_inverse m_front;
  Aligned_vector<double> m_stack;
  std::size_t m_top = 0; // of the stack
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_SELECTED_INVERSE_H
