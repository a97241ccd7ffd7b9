// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_WEIGHTED_GRAPH_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_WEIGHTED_GRAPH_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/Sparse_cholesky.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The Laplacian L of a graph with positive weights, plus a diagonal D, factored: solves (L + D) x = b for several b.
class Weighted_graph
{
public:
  typedef Compressed_rows::Index Index;

  // `ends`: of each edge; an edge may be there several times, its weights are added. `weights`: of each edge.
  // `diagonal(i, w)`: D for row i, where the weights of its edges are w together. `points`: where the nodes are, for the
  // order of elimination.
  // Throws Numerical_error if L + D is not positive definite.
  template <class Diagonal, class Point>
  Weighted_graph(const std::vector<std::array<Index, 2>>& ends, const std::vector<double>& weights,
                 const Diagonal& diagonal, const std::vector<Point>& points)
    : m_symbolic(neighbours(points.size(), ends), points)
    , m_factor(factor(m_symbolic, ends, weights, diagonal))
  {}
  Weighted_graph(const Weighted_graph&) = delete;
  Weighted_graph& operator=(const Weighted_graph&) = delete;

  const Symbolic_cholesky& symbolic() const { return m_symbolic; }
  void solve(Right_hand_sides<double>& x) const { m_factor.solve(x); }

private:
  static Compressed_rows neighbours(std::size_t n, const std::vector<std::array<Index, 2>>& ends)
  {
    std::vector<Index> sizes(n, 0);
    for (const auto& e : ends)
      for (Index i : e) ++sizes[i];
    Compressed_rows rows(sizes);
    std::fill(sizes.begin(), sizes.end(), 0);
    for (const auto& e : ends) {
      rows.row(e[0])[sizes[e[0]]++] = e[1];
      rows.row(e[1])[sizes[e[1]]++] = e[0];
    }
    Compressed_rows unique;
    for (std::size_t i = 0; i < n; ++i) {
      Index* const first = rows.row(i);
      std::sort(first, first + sizes[i]);
      unique.push_back(first, std::unique(first, first + sizes[i]));
    }
    return unique;
  }

  template <class Diagonal>
  static Sparse_cholesky<double> factor(const Symbolic_cholesky& symbolic, const std::vector<std::array<Index, 2>>& ends,
                                        const std::vector<double>& weights, const Diagonal& diagonal)
  {
    const Compressed_rows& rows = symbolic.neighbours();
    const auto place = [&rows](std::size_t i, Index j) {
      const Compressed_rows::Row row = rows[i];
      return std::size_t(std::lower_bound(row.begin(), row.end(), j) - rows[0].begin());
    };
    std::vector<double> values(rows.number_of_entries(), 0), sums(rows.size(), 0);
    for (std::size_t e = 0; e < ends.size(); ++e) {
      const Index i = ends[e][0], j = ends[e][1];
      values[place(i, j)] += weights[e];
      values[place(j, i)] += weights[e];
      sums[i] += weights[e];
      sums[j] += weights[e];
    }
    return Sparse_cholesky<double>(
        symbolic, [&](std::size_t i) { return sums[i] + diagonal(i, sums[i]); },
        [&](std::size_t i, std::size_t k) { return -values[std::size_t(rows[i].begin() - rows[0].begin()) + k]; });
  }

  Symbolic_cholesky m_symbolic;
  Sparse_cholesky<double> m_factor;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_WEIGHTED_GRAPH_H
