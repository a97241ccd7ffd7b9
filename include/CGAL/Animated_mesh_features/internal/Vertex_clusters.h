// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_VERTEX_CLUSTERS_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_VERTEX_CLUSTERS_H

#include <CGAL/Animated_mesh_features/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Rest_shape.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Groups of vertices, each of those to which a seed is nearer than any other seed, by paths along edges. A next seed is
// where the distance from all seeds so far is just above `radius`: seeds are packed almost as densely as their
// distance allows. The first is the outermost vertex
// of a component, so that the numbering of the vertices decides ties only, and a component has the clusters that it would
// have alone.
class Vertex_clusters
{
public:
  typedef Rest_shape::Index Index;

  Vertex_clusters(const Rest_shape& shape, double radius)
    : m_shape(&shape)
    , m_radius(radius)
    , m_distance(shape.number_of_vertices(), infinity)
    , m_cluster(shape.number_of_vertices(), Rest_shape::none)
  {
    for (std::size_t v = 0; v < m_cluster.size(); ++v) {
      if (m_cluster[v] != Rest_shape::none) continue;
      add(outermost_of_component(Index(v)));
      while (!m_candidates.empty()) {
        const Entry top = m_candidates.top();
        m_candidates.pop();
        if (top.first == m_distance[top.second]) add(top.second); // else another seed has come nearer
      }
    }
  }

  // The vertices of each cluster, ascending.
  Compressed_rows rows() const
  {
    std::vector<Compressed_rows::Index> sizes(m_number_of_clusters, 0);
    for (Index c : m_cluster) ++sizes[c];
    Compressed_rows result(sizes);
    std::vector<Index*> next;
    for (std::size_t c = 0; c < m_number_of_clusters; ++c) next.push_back(result.row(c));
    for (std::size_t v = 0; v < m_cluster.size(); ++v) *next[m_cluster[v]]++ = Index(v);
    return result;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  typedef std::pair<double, Index> Entry;
  typedef std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Queue;

  // The vertex that is farthest from the mean of those that edges connect with v.
  Index outermost_of_component(Index v)
  {
    constexpr Index met = Rest_shape::none - 1;
    std::vector<Index> component(1, v);
    m_cluster[v] = met;
    Rest_shape::Point centre = Rest_shape::Point::Zero();
    for (std::size_t i = 0; i < component.size(); ++i) {
      centre += m_shape->points()[component[i]];
      for (Index w : m_shape->neighbours()[component[i]])
        if (m_cluster[w] != met) {
          m_cluster[w] = met;
          component.push_back(w);
        }
    }
    centre /= double(component.size());
    Index result = v;
    double farthest = -1;
    for (Index w : component) {
      m_cluster[w] = Rest_shape::none;
      const double d = (m_shape->points()[w] - centre).squaredNorm();
      if (d > farthest || (d == farthest && w < result)) {
        farthest = d;
        result = w;
      }
    }
    return result;
  }

  // Gives to the seed what is nearer to it than to the seeds before. Beyond the radius a vertex passes the search on no
  // more, but becomes a candidate.
  void add(Index seed)
  {
    const Index cluster = Index(m_number_of_clusters++);
    Queue queue;
    m_distance[seed] = 0;
    m_cluster[seed] = cluster;
    queue.emplace(0, seed);
    while (!queue.empty()) {
      const Entry top = queue.top();
      queue.pop();
      const Index v = top.second;
      if (top.first > m_distance[v]) continue;
      for (Index e : m_shape->incident_edges()[v]) {
        const Rest_shape::Edge& edge = m_shape->edges()[e];
        const Index w = edge.source == v ? edge.target : edge.source;
        const double d = top.first + m_shape->lengths()[e];
        if (!(d < m_distance[w])) continue;
        m_distance[w] = d;
        if (d > m_radius)
          m_candidates.emplace(d, w);
        else {
          m_cluster[w] = cluster;
          queue.emplace(d, w);
        }
      }
    }
  }

  const Rest_shape* m_shape;
  double m_radius;
  std::vector<double> m_distance;
  std::vector<Index> m_cluster;
  std::size_t m_number_of_clusters = 0;
  Queue m_candidates;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_VERTEX_CLUSTERS_H
