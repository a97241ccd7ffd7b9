// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_ROWS_OF_VERTICES_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_ROWS_OF_VERTICES_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Sorts by `row` first, which is the index of one of `vertices` vertices, then by `less`. Rows are short: this takes linear
// time, where sorting the whole would not.
template <class Element, class Row, class Less>
std::vector<Element>
sorted_in_rows(std::size_t vertices, const std::vector<Element>& elements, const Row& row, const Less& less)
{
  std::vector<std::size_t> ends(vertices + 1, 0);
  for (const Element& e : elements) ++ends[row(e) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Element> sorted(elements.size());
  for (const Element& e : elements) sorted[ends[row(e)]++] = e; // starts become ends on the way
  std::size_t begin = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    std::sort(sorted.begin() + std::ptrdiff_t(begin), sorted.begin() + std::ptrdiff_t(ends[v]), less);
    begin = ends[v];
  }
  return sorted;
}

// A row for each vertex: those of the simplices `simplex(0)`, `simplex(1)`, ... of which it is a corner, in this order.
template <class Simplex, class Corners>
Compressed_rows
rows_of_vertices(std::size_t vertices, std::size_t simplices, const Simplex& simplex, const Corners& corners)
{
  typedef Compressed_rows::Index Index;
  std::vector<std::size_t> ends(vertices + 1, 0);
  for (std::size_t i = 0; i < simplices; ++i)
    for (Index v : corners(simplex(i))) ++ends[v + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Index> entries(ends.back());
  for (std::size_t i = 0; i < simplices; ++i)
    for (Index v : corners(simplex(i))) entries[ends[v]++] = simplex(i); // starts become ends on the way
  Compressed_rows rows;
  const Index* begin = entries.data();
  for (std::size_t v = 0; v < vertices; ++v) {
    const Index* const end = entries.data() + ends[v];
    rows.push_back(begin, end);
    begin = end;
  }
  return rows;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_ROWS_OF_VERTICES_H
