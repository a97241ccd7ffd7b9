// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_BOUNDED_DIJKSTRA_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_BOUNDED_DIJKSTRA_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Shortest paths along edges up to a limit, from one or several sources. Between runs only what was touched is cleared,
// so that a run costs O(k log k) for k vertices within the limit, whatever the size of the mesh.
class Bounded_dijkstra
{
public:
  typedef Rest_shape::Index Index;

  explicit Bounded_dijkstra(const Rest_shape& shape)
    : m_shape(&shape)
    , m_distance(shape.number_of_vertices(), infinity)
  {
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // The vertices within the limit in order of increasing distance (ties by index).
  template <class Sources>
  const std::vector<Index>& run(const Sources& sources, double limit)
  {
    clear();
    for (Index s : sources) reach(s, 0);
    while (!m_queue.empty()) {
      const std::pair<double, Index> top = m_queue.top();
      m_queue.pop();
      const Index v = top.second;
      if (top.first > m_distance[v]) continue; // reached on a shorter path meanwhile
      m_reached.push_back(v);
      const auto edges = m_shape->incident_edges()[v];
      for (Index e : edges) {
        const Rest_shape::Edge& edge = m_shape->edges()[e];
        const double d = top.first + m_shape->lengths()[e];
        if (d <= limit) reach(edge.source == v ? edge.target : edge.source, d);
      }
    }
    return m_reached;
  }

  // Length of the shortest path of the last run; infinity beyond its limit.
  double distance(Index v) const { return m_distance[v]; }

private:
  void reach(Index v, double d)
  {
    if (!(d < m_distance[v])) return;
    if (m_distance[v] == infinity) m_touched.push_back(v);
    m_distance[v] = d;
    m_queue.emplace(d, v);
  }

  void clear()
  {
    for (Index v : m_touched) m_distance[v] = infinity;
    m_touched.clear();
    m_reached.clear();
  }

  typedef std::pair<double, Index> Entry;
  const Rest_shape* m_shape;
  std::vector<double> m_distance;
  std::vector<Index> m_touched, m_reached;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_BOUNDED_DIJKSTRA_H
