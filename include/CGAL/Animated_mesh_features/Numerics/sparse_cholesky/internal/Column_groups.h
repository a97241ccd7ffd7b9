// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_COLUMN_GROUPS_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_COLUMN_GROUPS_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/elimination_tree.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The columns of a factor in groups: those with the same rows below; then a group and its parent become one where the
// zeros that this fills in cost less than it saves; C. Ashcraft, R. Grimes, The influence of relaxed supernode
// partitions on the multifrontal method, ACM Trans. Math. Softw. 15(4), 1989. Columns are numbered such that those of a
// group are consecutive.
class Column_groups
{
public:
  typedef Compressed_rows::Index Index;

  Column_groups(const Compressed_rows& neighbours, const Elimination_order& order)
    : m_order(in_postorder(neighbours, order))
  {
    find_equal_columns(neighbours);
    merge_into_parents();
    number_columns();
  }

  // The order of the matrix's rows.
  Elimination_order& order() { return m_order; }

  // Columns of each group.
  const std::vector<Index>& widths() const { return m_widths; }

private:
  struct Group
  {
    double width, height;     // columns, rows below
    Index parent = no_parent; // in the elimination tree
    Index whole = no_parent;  // the group that it has become a part of
    bool is_part() const { return whole != no_parent; }
  };

  // What a solve with a panel costs, in units of a product: each row below is fetched and written, and there is some
  // effort for a panel. Measured; anything between half and twice as much is as good.
  static double cost(double width, double height) { return width * (width / 2 + height) + 4 * height + 8; }

  void find_equal_columns(const Compressed_rows& neighbours)
  {
    const std::size_t n = neighbours.size();
    const std::vector<Index> parent = elimination_tree(neighbours, m_order);
    const std::vector<Index> heights = column_heights(neighbours, m_order, parent);
    std::vector<Index> children(n, 0);
    for (Index p : parent)
      if (p != no_parent) ++children[p];
    m_group.resize(n);
    std::vector<Index> last; // column of each group
    for (std::size_t j = 0; j < n; ++j) {
      if (j > 0 && parent[j - 1] == j && children[j] == 1 && heights[j - 1] == heights[j] + 1) {
        m_groups.back().width += 1;
        m_groups.back().height = heights[j];
        last.back() = Index(j);
      } else {
        m_groups.push_back({1, double(heights[j])});
        last.push_back(Index(j));
      }
      m_group[j] = Index(m_groups.size() - 1);
    }
    for (std::size_t g = 0; g < m_groups.size(); ++g)
      if (parent[last[g]] != no_parent) m_groups[g].parent = m_group[parent[last[g]]];
  }

  void merge_into_parents()
  {
    for (Group& child : m_groups) { // children before parents
      if (child.parent == no_parent) continue;
      Group& p = m_groups[child.parent];
      if (cost(child.width + p.width, p.height) > cost(child.width, child.height) + cost(p.width, p.height)) continue;
      p.width += child.width;
      child.whole = child.parent;
    }
    // the group that each is part of in the end: parents have larger numbers
    for (std::size_t g = m_groups.size(); g-- > 0;)
      if (m_groups[g].is_part() && m_groups[m_groups[g].whole].is_part())
        m_groups[g].whole = m_groups[m_groups[g].whole].whole;
    for (Group& g : m_groups)
      if (g.parent != no_parent && m_groups[g.parent].is_part()) g.parent = m_groups[g.parent].whole;
  }

  // Columns group by group, and groups in postorder.
  void number_columns()
  {
    std::vector<Index> parent(m_groups.size());
    for (std::size_t g = 0; g < m_groups.size(); ++g)
      parent[g] = m_groups[g].is_part() ? no_parent : m_groups[g].parent; // parts are no nodes of the tree
    std::vector<std::vector<Index>> columns(m_groups.size());
    for (std::size_t j = 0; j < m_order.size(); ++j) {
      const Index g = m_group[j];
      columns[m_groups[g].is_part() ? m_groups[g].whole : g].push_back(Index(j));
    }
    std::vector<Index> original;
    original.reserve(m_order.size());
    for (Index g : postorder(parent)) {
      if (columns[g].empty()) continue;
      m_widths.push_back(Index(columns[g].size()));
      for (Index j : columns[g]) original.push_back(m_order.original[j]);
    }
    m_order = Elimination_order(std::move(original));
  }

  Elimination_order m_order;
  std::vector<Index> m_group; // of each column
  std::vector<Group> m_groups;
  std::vector<Index> m_widths;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_COLUMN_GROUPS_H
