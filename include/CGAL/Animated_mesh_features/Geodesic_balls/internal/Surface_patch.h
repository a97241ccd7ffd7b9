// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_SURFACE_PATCH_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_SURFACE_PATCH_H

#include <CGAL/Animated_mesh_features/Animation/Animation_report.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A part of a rest shape with numbers of its own, which ascend with those of the shape. It is made over and over again
// in the same memory.
class Surface_patch
{
public:
  typedef Rest_shape::Index Index;
  static constexpr Index none = Rest_shape::none;

  struct Neighbour
  {
    Index vertex;  // of this patch
    double length; // of the edge
  };

  explicit Surface_patch(const Rest_shape& shape)
    : m_shape(&shape)
    , m_number(shape.number_of_vertices(), none)
  {}

  // The triangles that have a corner among `reached`, and all edges between their corners, of whatever triangle.
  void set(const std::vector<Index>& reached)
  {
    clear();
    // not none: reached; the numbers follow when all vertices are known
    for (Index v : reached) m_number[v] = 0;
    m_vertices = reached;
    std::sort(m_vertices.begin(), m_vertices.end());
    const std::size_t inside = m_vertices.size();
    for (std::size_t i = 0; i < inside; ++i) {
      const Index v = m_vertices[i];
      for (Index t : m_shape->incident_triangles()[v]) {
        const Rest_shape::Triangle& corners = m_shape->triangles()[t];
        bool first = true; // among the triangle's reached corners
        for (Index w : corners)
          if (m_number[w] == none) {
            m_number[w] = 1;
            m_vertices.push_back(w);
          } else if (m_number[w] == 0 && w < v)
            first = false;
        if (first && !is_degenerate(*m_shape, t)) m_triangles.push_back(corners);
      }
    }
    std::sort(m_vertices.begin(), m_vertices.end());
    for (std::size_t i = 0; i < m_vertices.size(); ++i) m_number[m_vertices[i]] = Index(i);
    for (Rest_shape::Triangle& t : m_triangles)
      for (Index& v : t) v = m_number[v];
    for (Index v : m_vertices) {
      m_points.push_back(m_shape->points()[v]);
      add_neighbours(v);
      m_offsets.push_back(m_neighbours.size());
    }
  }

  std::size_t number_of_vertices() const { return m_vertices.size(); }

  // indices in the shape, ascending
  const std::vector<Index>& vertices() const { return m_vertices; }

  // the number of a vertex of the shape; none if it is not of this patch
  Index number(Index v) const { return m_number[v]; }

  // those that are not degenerate
  const std::vector<Rest_shape::Triangle>& triangles() const { return m_triangles; }
  const std::vector<Rest_shape::Point>& points() const { return m_points; }
  boost::iterator_range<const Neighbour*> neighbours(std::size_t v) const
  {
    return {m_neighbours.data() + m_offsets[v], m_neighbours.data() + m_offsets[v + 1]};
  }

private:
  void clear()
  {
    for (Index v : m_vertices) m_number[v] = none;
    m_triangles.clear();
    m_points.clear();
    m_neighbours.clear();
    m_offsets.assign(1, 0);
  }

  void add_neighbours(Index v)
  {
    for (Index e : m_shape->incident_edges()[v]) {
      const Rest_shape::Edge& edge = m_shape->edges()[e];
      const Index w = m_number[edge.source == v ? edge.target : edge.source];
      if (w == none) continue;
      if (m_neighbours.size() > m_offsets.back() && m_neighbours.back().vertex == w) continue; // a double edge
      m_neighbours.push_back({w, m_shape->lengths()[e]});
    }
  }

  const Rest_shape* m_shape;
  std::vector<Index> m_number;
  std::vector<Index> m_vertices;
  std::vector<Rest_shape::Triangle> m_triangles;
  std::vector<Rest_shape::Point> m_points;
  std::vector<std::size_t> m_offsets;
  std::vector<Neighbour> m_neighbours;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_SURFACE_PATCH_H
