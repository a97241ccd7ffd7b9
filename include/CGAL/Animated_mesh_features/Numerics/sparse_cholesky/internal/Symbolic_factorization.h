// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_SYMBOLIC_FACTORIZATION_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_SYMBOLIC_FACTORIZATION_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Cholesky_panel.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Column_groups.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/elimination_tree.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Which entries the Cholesky factor of a symmetric matrix has, in panels.
class Symbolic_factorization
{
public:
  typedef Compressed_rows::Index Index;
  typedef Cholesky_panel Panel;

  // `neighbours`: for each row of the matrix the columns of its entries off the diagonal. `order`: the row that is
  // eliminated first, and so on, such that there is little fill.
  Symbolic_factorization(const Compressed_rows& neighbours, std::vector<Index> order)
  {
    Column_groups groups(neighbours, Elimination_order(std::move(order)));
    m_order = std::move(groups.order());
    find_panels(neighbours, groups.widths());
    measure_stack();
  }

  std::size_t number_of_columns() const { return m_order.size(); }
  const std::vector<Panel>& panels() const { return m_panels; }

  // Number in the factor of a row of the matrix, and back.
  const std::vector<Index>& position() const { return m_order.position; }
  const std::vector<Index>& original() const { return m_order.original; }

  // The rows below the columns of a panel, ascending, then number_of_columns() as often as tiles need to be full.
  const Index* rows(const Panel& p) const { return m_rows.data() + p.rows; }

  // Numbers in a factor.
  std::size_t number_of_values() const { return m_number_of_values; }

  // Numbers in the updates that wait for their parents, at most.
  std::size_t stack_size() const { return m_stack_size; }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  // The panels whose first row below is the same one, as a list.
  struct Waiting_panels
  {
    std::vector<Index> last; // the last panel that waits for each row
    std::vector<Index> next; // for each panel the one that waits for the same row and came before it
  };

  void find_panels(const Compressed_rows& neighbours, const std::vector<Index>& widths)
  {
    const std::size_t n = neighbours.size();
    std::vector<Index> mark(n, none), below;
    Waiting_panels waiting{std::vector<Index>(n, none), {}};
    Index first = 0;
    for (std::size_t g = 0; g < widths.size(); ++g) {
      if (g % 1024 == 0) cancellation_point();
      const Index end = first + widths[g];
      const Index children = find_rows(neighbours, first, end, waiting, Index(g), mark, below);
      cut_into_panels(first, end, below, children);
      waiting.next.resize(m_panels.size(), none);
      if (!below.empty()) {
        waiting.next.back() = waiting.last[below.front()];
        waiting.last[below.front()] = Index(m_panels.size() - 1);
      }
      first = end;
    }
  }

  // The rows below the columns [first, end) of a group, ascending: those of the matrix, and those of the panels that
  // have their first row below here. Returns how many panels these are. Rows that are there are marked by the number of
  // the group.
  Index find_rows(const Compressed_rows& neighbours, Index first, Index end, const Waiting_panels& waiting, Index group,
                  std::vector<Index>& mark, std::vector<Index>& below) const
  {
    below.clear();
    const auto add = [&](Index i) {
      if (i >= end && mark[i] != group) {
        mark[i] = group;
        below.push_back(i);
      }
    };
    Index children = 0;
    for (Index j = first; j < end; ++j) {
      for (Index w : neighbours[m_order.original[j]]) add(m_order.position[w]);
      for (Index p = waiting.last[j]; p != none; p = waiting.next[p], ++children) {
        const Index* r = rows(m_panels[p]);
        std::for_each(r, r + m_panels[p].height, add);
      }
    }
    std::sort(below.begin(), below.end());
    return children;
  }

  // Panels of about the same width, by whole tiles, each the only child of the next.
  void cut_into_panels(Index first, Index end, const std::vector<Index>& below, Index children)
  {
    constexpr std::size_t tile = Panel::tile;
    const std::size_t n = number_of_columns(), width = end - first;
    const std::size_t parts = (width + Panel::widest - 1) / Panel::widest;
    const std::size_t part = Panel::number_of_tiles((width + parts - 1) / parts) * tile;
    for (std::size_t from = first; from < end; from += part) {
      Panel p;
      p.first = Index(from);
      p.width = Index((std::min)(part, end - from));
      p.height = Index(end - from - p.width + below.size());
      p.children = from == first ? children : 1;
      p.rows = m_rows.size();
      p.values = m_number_of_values;
      for (std::size_t i = from + p.width; i < end; ++i) m_rows.push_back(Index(i));
      m_rows.insert(m_rows.end(), below.begin(), below.end());
      m_rows.resize(p.rows + Panel::number_of_tiles(p.height) * tile, Index(n));
      m_number_of_values += p.size();
      m_panels.push_back(p);
    }
  }

  void measure_stack()
  {
    std::vector<std::size_t> waiting;
    std::size_t now = 0;
    for (const Panel& p : m_panels) {
      m_stack_size = (std::max)(m_stack_size, now + p.update_size());
      for (std::size_t i = 0; i < p.children; ++i) {
        now -= waiting.back();
        waiting.pop_back();
      }
      waiting.push_back(p.update_size());
      now += waiting.back();
    }
  }

  Elimination_order m_order;
  std::vector<Panel> m_panels;
  std::vector<Index> m_rows;
  std::size_t m_number_of_values = 0, m_stack_size = 0;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_SYMBOLIC_FACTORIZATION_H
