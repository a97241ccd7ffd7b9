// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_SYMBOLIC_FACTORIZATION_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_SYMBOLIC_FACTORIZATION_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Which entries the Cholesky factor of a symmetric matrix has, in panels: runs of columns that share the rows below
// them, so that all arithmetic is on small dense matrices. A panel is stored in tiles of four rows, column after column:
// first those of its own columns, a triangle, then those of the rows below, filled up with rows that do not exist.
class Symbolic_factorization
{
public:
  typedef std::uint32_t Index;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  // Rows of a tile: a register of doubles with AVX2.
  static constexpr std::size_t tile = 4;

  // Columns of a panel at most: 64 columns of a tile are 2 KiB, so that two tiles and what they are multiplied with stay
  // in the L1 cache, while wide fronts are still worked off by products of matrices.
  static constexpr std::size_t widest = 64;

  struct Panel
  {
    Index first;        // column
    Index width;        // columns
    Index height;       // rows below
    Index children;     // panels whose parent this is; they come right before it, in postorder
    std::size_t rows;   // where its rows are, in `rows()`
    std::size_t values; // where its values are, in those of a factor
  };

  // Numbers in a tile of the triangle, and in all of those before it. The last tile has the panel's width only.
  static std::size_t triangle_tiles(std::size_t i) { return tile * tile * i * (i + 1) / 2; }
  static std::size_t number_of_tiles(std::size_t rows) { return (rows + tile - 1) / tile; }
  static std::size_t triangle_size(std::size_t width)
  {
    const std::size_t last = number_of_tiles(width) - 1;
    return triangle_tiles(last) + tile * width;
  }
  static std::size_t size(const Panel& p)
  {
    return triangle_size(p.width) + number_of_tiles(p.height) * tile * p.width;
  }
  // Numbers in what a panel passes on to its parent: the lower triangle of a square matrix, stored with its upper one.
  static std::size_t update_size(const Panel& p) { return number_of_tiles(p.height) * tile * p.height; }

  // `neighbours`: for each row of the matrix the columns of its entries off the diagonal. `order`: the row that is
  // eliminated first, and so on, such that there is little fill.
  Symbolic_factorization(const Compressed_rows& neighbours, std::vector<Index> order)
  {
    set_order(std::move(order));
    order_columns(neighbours);
    merge_columns(neighbours);
    find_rows(neighbours);
  }

  std::size_t number_of_columns() const { return m_position.size(); }
  const std::vector<Panel>& panels() const { return m_panels; }

  // Number in the factor of a row of the matrix, and back.
  const std::vector<Index>& position() const { return m_position; }
  const std::vector<Index>& original() const { return m_original; }

  // The rows below the columns of a panel, ascending, then number_of_columns() as often as tiles need to be full.
  const Index* rows(const Panel& p) const { return m_rows.data() + p.rows; }

  // Numbers in a factor.
  std::size_t number_of_values() const { return m_number_of_values; }

  // Numbers in the updates that wait for their parents, at most.
  std::size_t stack_size() const { return m_stack_size; }

private:
  // Postorder of the elimination tree, which leaves the fill as it is. J. W. H. Liu, The role of elimination trees in
  // sparse factorization, SIAM J. Matrix Anal. Appl. 11(1), 1990.
  void order_columns(const Compressed_rows& neighbours)
  {
    const std::size_t n = neighbours.size();
    find_elimination_tree(neighbours);
    const std::vector<Index> order = postorder(m_parent);
    std::vector<Index> original(n);
    for (std::size_t i = 0; i < n; ++i) original[i] = m_original[order[i]];
    set_order(std::move(original));
    find_elimination_tree(neighbours);
  }

  void set_order(std::vector<Index> original)
  {
    m_original = std::move(original);
    m_position.resize(m_original.size());
    for (std::size_t i = 0; i < m_original.size(); ++i) m_position[m_original[i]] = Index(i);
  }

  void find_elimination_tree(const Compressed_rows& neighbours)
  {
    const std::size_t n = neighbours.size();
    m_parent.assign(n, none);
    std::vector<Index> ancestor(n, none);
    for (std::size_t j = 0; j < n; ++j)
      for (Index w : neighbours[m_original[j]])
        for (Index i = m_position[w]; i < j;) {
          const Index next = ancestor[i];
          ancestor[i] = Index(j);
          if (next == none) m_parent[i] = Index(j);
          i = next;
        }
  }

  // The nodes of a forest whose parents have larger numbers: children, in the order of their numbers, before parents.
  static std::vector<Index> postorder(const std::vector<Index>& parent)
  {
    const std::size_t n = parent.size();
    std::vector<Index> first(n, none), next(n, none), order, stack;
    order.reserve(n);
    for (std::size_t i = n; i-- > 0;)
      if (parent[i] != none) {
        next[i] = first[parent[i]];
        first[parent[i]] = Index(i);
      }
    for (std::size_t root = 0; root < n; ++root) {
      if (parent[root] != none) continue;
      stack.push_back(Index(root));
      while (!stack.empty()) {
        const Index i = stack.back();
        if (first[i] == none) {
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

  // Entries below the diagonal of each column of the factor.
  std::vector<Index> column_heights(const Compressed_rows& neighbours) const
  {
    const std::size_t n = neighbours.size();
    std::vector<Index> heights(n, 0), mark(n, none);
    for (std::size_t j = 0; j < n; ++j) {
      mark[j] = Index(j);
      for (Index w : neighbours[m_original[j]])
        for (Index i = m_position[w]; i < j && mark[i] != j; i = m_parent[i]) {
          mark[i] = Index(j);
          ++heights[i];
        }
    }
    return heights;
  }

  // What a solve with a panel costs, in units of a product: each row below is fetched and written, and there is some
  // effort for a panel. Measured; anything between half and twice as much is as good.
  static double cost(double width, double height) { return width * (width / 2 + height) + 4 * height + 8; }

  // Columns with the same rows below make a panel; so do a panel and its parent where the zeros that this fills in cost
  // less than it saves; C. Ashcraft, R. Grimes, The influence of relaxed supernode partitions on the multifrontal
  // method, ACM Trans. Math. Softw. 15(4), 1989. Then the columns are numbered anew, so that those of a panel are
  // consecutive.
  void merge_columns(const Compressed_rows& neighbours)
  {
    const std::size_t n = neighbours.size();
    const std::vector<Index> heights = column_heights(neighbours);
    std::vector<Index> children(n, 0);
    for (Index p : m_parent)
      if (p != none) ++children[p];
    std::vector<Index> group(n); // of each column
    struct Group
    {
      double width, height;
    };
    std::vector<Group> groups;
    std::vector<Index> last;
    for (std::size_t j = 0; j < n; ++j) {
      if (j > 0 && m_parent[j - 1] == j && children[j] == 1 && heights[j - 1] == heights[j] + 1) {
        groups.back().width += 1;
        groups.back().height = heights[j];
        last.back() = Index(j);
      } else {
        groups.push_back({1, double(heights[j])});
        last.push_back(Index(j));
      }
      group[j] = Index(groups.size() - 1);
    }
    const std::size_t m = groups.size();
    std::vector<Index> parent(m, none), into(m, none);
    for (std::size_t g = 0; g < m; ++g)
      if (m_parent[last[g]] != none) parent[g] = group[m_parent[last[g]]];
    for (std::size_t g = 0; g < m; ++g) { // children before parents
      if (parent[g] == none) continue;
      const Group& child = groups[g];
      Group& p = groups[parent[g]];
      if (cost(child.width + p.width, p.height) > cost(child.width, child.height) + cost(p.width, p.height)) continue;
      p.width += child.width;
      into[g] = parent[g];
    }
    // the group that each is part of in the end: parents have larger numbers
    for (std::size_t g = m; g-- > 0;)
      if (into[g] != none && into[into[g]] != none) into[g] = into[into[g]];
    for (std::size_t g = 0; g < m; ++g)
      if (parent[g] != none && into[parent[g]] != none) parent[g] = into[parent[g]];
    for (std::size_t g = 0; g < m; ++g)
      if (into[g] != none) parent[g] = none; // parts are no nodes of the tree
    std::vector<std::vector<Index>> columns(m);
    for (std::size_t j = 0; j < n; ++j) columns[into[group[j]] == none ? group[j] : into[group[j]]].push_back(Index(j));
    std::vector<Index> original;
    original.reserve(n);
    for (Index g : postorder(parent)) {
      if (columns[g].empty()) continue;
      m_widths.push_back(Index(columns[g].size()));
      for (Index j : columns[g]) original.push_back(m_original[j]);
    }
    set_order(std::move(original));
    std::vector<Index>().swap(m_parent);
  }

  // The rows of each group of columns: those of the matrix and of the groups that have their next row here. Then it is
  // cut into panels.
  void find_rows(const Compressed_rows& neighbours)
  {
    const std::size_t n = neighbours.size();
    std::vector<Index> mark(n, none), waiting(n, none); // waiting: the last panel whose first row below is there
    std::vector<Index> next;                            // the panel before it, for each panel
    std::vector<Index> below;
    Index first = 0;
    for (std::size_t g = 0; g < m_widths.size(); ++g) {
      const Index end = first + m_widths[g];
      below.clear();
      const auto add = [&](Index i) {
        if (i >= end && mark[i] != g) {
          mark[i] = Index(g);
          below.push_back(i);
        }
      };
      std::vector<Index> children;
      for (Index j = first; j < end; ++j) {
        for (Index w : neighbours[m_original[j]]) add(m_position[w]);
        for (Index p = waiting[j]; p != none; p = next[p]) {
          const Index* r = rows(m_panels[p]);
          std::for_each(r, r + m_panels[p].height, add);
          children.push_back(p);
        }
      }
      std::sort(below.begin(), below.end());
      const std::size_t parts = (m_widths[g] + widest - 1) / widest; // of about the same width, by whole tiles
      const std::size_t part = number_of_tiles((m_widths[g] + parts - 1) / parts) * tile;
      for (std::size_t from = first; from < end; from += part) {
        Panel p;
        p.first = Index(from);
        p.width = Index((std::min)(part, end - from));
        p.height = Index(end - from - p.width + below.size());
        p.children = from == first ? Index(children.size()) : 1;
        p.rows = m_rows.size();
        p.values = m_number_of_values;
        for (std::size_t i = from + p.width; i < end; ++i) m_rows.push_back(Index(i));
        m_rows.insert(m_rows.end(), below.begin(), below.end());
        m_rows.resize(p.rows + number_of_tiles(p.height) * tile, Index(n));
        m_number_of_values += size(p);
        m_panels.push_back(p);
        next.push_back(none);
      }
      if (!below.empty()) {
        next.back() = waiting[below.front()];
        waiting[below.front()] = Index(m_panels.size() - 1);
      }
      first = end;
    }
    std::vector<Index>().swap(m_widths);
    measure_stack();
  }

  void measure_stack()
  {
    std::vector<std::size_t> waiting;
    std::size_t now = 0;
    for (const Panel& p : m_panels) {
      m_stack_size = (std::max)(m_stack_size, now + update_size(p));
      for (std::size_t i = 0; i < p.children; ++i) {
        now -= waiting.back();
        waiting.pop_back();
      }
      waiting.push_back(update_size(p));
      now += waiting.back();
    }
  }

  std::vector<Index> m_position, m_original;
  std::vector<Panel> m_panels;
  std::vector<Index> m_rows;
  std::size_t m_number_of_values = 0, m_stack_size = 0;
  std::vector<Index> m_parent, m_widths; // while it is made
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_SYMBOLIC_FACTORIZATION_H
