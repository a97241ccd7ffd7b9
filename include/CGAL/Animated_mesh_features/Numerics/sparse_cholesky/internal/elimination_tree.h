// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_ELIMINATION_TREE_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_ELIMINATION_TREE_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The order in which the rows of a matrix are eliminated.
struct Elimination_order
{
  typedef Compressed_rows::Index Index;

  std::vector<Index> original; // the row that is eliminated first, and so on
  std::vector<Index> position; // when each row is eliminated: its number, and that of its column, in the factor

  Elimination_order() = default;
  explicit Elimination_order(std::vector<Index> rows)
    : original(std::move(rows))
    , position(original.size())
  {
    for (std::size_t i = 0; i < original.size(); ++i) position[original[i]] = Index(i);
  }

  std::size_t size() const { return original.size(); }
};

// The parent of a root.
constexpr Compressed_rows::Index no_parent = (std::numeric_limits<Compressed_rows::Index>::max)();

// The parent of each column of a factor: the row of its first entry below the diagonal. J. W. H. Liu, The role of
// elimination trees in sparse factorization, SIAM J. Matrix Anal. Appl. 11(1), 1990.
inline std::vector<Compressed_rows::Index> elimination_tree(const Compressed_rows& neighbours,
                                                            const Elimination_order& order)
{
  typedef Compressed_rows::Index Index;
  const std::size_t n = neighbours.size();
  std::vector<Index> parent(n, no_parent), ancestor(n, no_parent);
  for (std::size_t j = 0; j < n; ++j)
    for (Index w : neighbours[order.original[j]])
      for (Index i = order.position[w]; i < j;) {
        const Index next = ancestor[i];
        ancestor[i] = Index(j);
        if (next == no_parent) parent[i] = Index(j);
        i = next;
      }
  return parent;
}

// The nodes of a forest whose parents have larger numbers: children, in the order of their numbers, before parents.
inline std::vector<Compressed_rows::Index> postorder(const std::vector<Compressed_rows::Index>& parent)
{
  typedef Compressed_rows::Index Index;
  const std::size_t n = parent.size();
  std::vector<Index> first(n, no_parent), next(n, no_parent), order, stack;
  order.reserve(n);
  for (std::size_t i = n; i-- > 0;)
    if (parent[i] != no_parent) {
      next[i] = first[parent[i]];
      first[parent[i]] = Index(i);
    }
  for (std::size_t root = 0; root < n; ++root) {
    if (parent[root] != no_parent) continue;
    stack.push_back(Index(root));
    while (!stack.empty()) {
      const Index i = stack.back();
      if (first[i] == no_parent) {
        order.push_back(i);
        stack.pop_back();
      } else {
        stack.push_back(first[i]);
        first[i] = next[first[i]];
      }
    }
  }
  return order;
}

// The postorder of the elimination tree of another order, which leaves the fill as it is.
inline Elimination_order in_postorder(const Compressed_rows& neighbours, const Elimination_order& order)
{
  std::vector<Compressed_rows::Index> original = postorder(elimination_tree(neighbours, order));
  for (Compressed_rows::Index& i : original) i = order.original[i];
  return Elimination_order(std::move(original));
}

// Entries below the diagonal of each column of the factor.
inline std::vector<Compressed_rows::Index> column_heights(const Compressed_rows& neighbours,
                                                          const Elimination_order& order,
                                                          const std::vector<Compressed_rows::Index>& parent)
{
  typedef Compressed_rows::Index Index;
  const std::size_t n = neighbours.size();
  std::vector<Index> heights(n, 0), last_row(n, no_parent); // the last one in which a column has an entry
  for (std::size_t j = 0; j < n; ++j) {
    last_row[j] = Index(j);
    for (Index w : neighbours[order.original[j]])
      for (Index i = order.position[w]; i < j && last_row[i] != j; i = parent[i]) {
        last_row[i] = Index(j);
        ++heights[i];
      }
  }
  return heights;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_ELIMINATION_TREE_H
