// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CORNER_ADJACENCY_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CORNER_ADJACENCY_H

#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Which triangles share edges, if they are a consistently oriented 2-manifold, possibly with border. Corner `3 t + i`
// is the i-th of triangle t, and stands for the edge along which t walks from there to its next corner. Linear time, but
// for vertices with very many neighbours.
class Corner_adjacency
{
public:
  typedef std::uint32_t Corner;
  static constexpr Corner none = (std::numeric_limits<Corner>::max)();

  explicit Corner_adjacency(const Indexed_mesh& mesh)
    : m_mesh(&mesh)
  {
    // at most two halfedges a corner
    m_is_manifold = mesh.triangles.size() < none / 6 && mesh.points.size() < none && find_twins() && check_fans();
  }

  // If not, nothing else can be asked. check_manifold() tells why.
  bool is_manifold() const { return m_is_manifold; }

  std::size_t number_of_corners() const { return m_twins.size(); }
  std::size_t number_of_edges() const { return m_edges; }

  // The corner for the same edge in the other triangle, or `none` on the border.
  Corner twin(Corner c) const { return m_twins[c]; }

  static Corner next(Corner c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static Corner previous(Corner c) { return c % 3 == 0 ? c + 2 : c - 1; }

  std::size_t vertex(Corner c) const { return m_mesh->triangles[c / 3][c % 3]; }

private:
  struct Edge_end
  {
    std::uint32_t larger_vertex;
    Corner corner;
  };

  // Edges are looked for among those with the same smaller vertex, which are a few.
  bool find_twins()
  {
    const std::size_t n = m_mesh->points.size();
    std::vector<Corner> ends(n + 1, 0);
    for (const auto& t : m_mesh->triangles) {
      if (t[0] >= n || t[1] >= n || t[2] >= n || t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return false;
      for (int i = 0; i < 3; ++i) ++ends[(std::min)(t[i], t[(i + 1) % 3]) + 1];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Edge_end> edges(ends.back());
    Corner corner = 0;
    for (const auto& t : m_mesh->triangles)
      for (int i = 0; i < 3; ++i, ++corner) {
        const std::size_t a = t[i], b = t[(i + 1) % 3];
        edges[ends[(std::min)(a, b)]++] = {std::uint32_t((std::max)(a, b)), corner}; // starts become ends on the way
      }
    m_twins.assign(edges.size(), none);
    auto first = edges.begin();
    for (std::size_t v = 0; v < n; ++v) {
      const auto last = edges.begin() + std::ptrdiff_t(ends[v]);
      std::sort(first, last, [](const Edge_end& a, const Edge_end& b) {
        return std::tie(a.larger_vertex, a.corner) < std::tie(b.larger_vertex, b.corner);
      });
      for (auto e = first; e != last;) {
        const auto other = e + 1;
        ++m_edges;
        if (other == last || other->larger_vertex != e->larger_vertex) {
          e = other; // on the border
          continue;
        }
        const auto third = other + 1;
        if (third != last && third->larger_vertex == e->larger_vertex) return false;
        if (vertex(e->corner) == vertex(other->corner)) return false;
        m_twins[e->corner] = other->corner;
        m_twins[other->corner] = e->corner;
        e = third;
      }
      first = last;
    }
    return true;
  }

  // Whether the triangles of each vertex are all met on the way around it.
  bool check_fans() const
  {
    std::vector<Corner> corners_of_vertex(m_mesh->points.size(), 0), first(m_mesh->points.size(), none);
    for (Corner c = 0; c < number_of_corners(); ++c) {
      const std::size_t v = vertex(c);
      if (corners_of_vertex[v]++ == 0) first[v] = c;
    }
    for (std::size_t v = 0; v < first.size(); ++v) {
      if (first[v] == none) continue;
      Corner met = 1, c = twin(previous(first[v]));
      for (; c != none && c != first[v]; c = twin(previous(c))) ++met;
      if (c == none) // at the border: the other way as well
        for (c = twin(first[v]); c != none; c = twin(next(c))) ++met;
      if (met != corners_of_vertex[v]) return false;
    }
    return true;
  }

  const Indexed_mesh* m_mesh;
  std::vector<Corner> m_twins;
  std::size_t m_edges = 0;
  bool m_is_manifold = false;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CORNER_ADJACENCY_H
