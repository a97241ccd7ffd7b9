// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_EDGE_GROUPS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_EDGE_GROUPS_H

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Calls `visit(first, last)` for every edge of a set of triangles with the corners that stand for it: the edge from a
// corner, three times the number of its triangle plus 0, 1 or 2, to the next one of its triangle. `vertex` tells the
// vertex at a corner, less than `number_of_vertices`. Corners come in ascending order. Linear, but for sorting the
// edges of each vertex.
template <class Vertex_of_corner, class Visit>
void for_each_edge(std::size_t number_of_corners, std::size_t number_of_vertices, const Vertex_of_corner& vertex,
                   const Visit& visit)
{
  const auto next = [](std::size_t c) { return c % 3 == 2 ? c - 2 : c + 1; };
  const auto smaller = [&](std::size_t c) { return (std::min)(vertex(c), vertex(next(c))); };
  const auto larger = [&](std::size_t c) { return (std::max)(vertex(c), vertex(next(c))); };

  std::vector<std::size_t> ends(number_of_vertices + 1, 0);
  for (std::size_t c = 0; c < number_of_corners; ++c) ++ends[smaller(c) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<std::size_t> sorted(number_of_corners);
  for (std::size_t c = 0; c < number_of_corners; ++c) sorted[ends[smaller(c)]++] = c; // starts become ends on the way
  std::size_t* begin = sorted.data();
  for (std::size_t v = 0; v < number_of_vertices; ++v) {
    std::size_t* const end = sorted.data() + ends[v];
    std::sort(begin, end, [&](std::size_t c, std::size_t d) {
      return std::make_tuple(larger(c), c) < std::make_tuple(larger(d), d);
    });
    for (std::size_t* last; begin != end; begin = last) {
      last = begin + 1;
      while (last != end && larger(*last) == larger(*begin)) ++last;
      visit(begin, last);
    }
  }
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_EDGE_GROUPS_H
