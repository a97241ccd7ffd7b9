// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_VERTEX_CLUSTERS_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_VERTEX_CLUSTERS_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Groups of vertices, each of those to which a seed is nearer than any other seed, by paths along edges. A next seed is
// where the distance from all seeds so far is just above `radius`: seeds are packed almost as densely as their distance
// allows. The first is the outermost vertex of a component, so that the numbering of the vertices decides ties only, and
// a component has the clusters that it would have alone.
class Vertex_clusters
{
public:
  typedef Rest_shape::Index Index;

  Vertex_clusters(const Rest_shape& shape, double radius)
    : m_shape(&shape)
    , m_unit(radius / double(radius_in_units))
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
  // Lengths are whole numbers, about billionths of the radius, so that what is equal but for rounding is equal: else,
  // on a regular mesh, clusters would change when the shape is turned.
  typedef std::uint64_t Length;
  static constexpr Length radius_in_units = Length(1) << 30;
  static constexpr Length infinity = (std::numeric_limits<Length>::max)();
  typedef std::pair<Length, Index> Entry;
  typedef std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Queue;

  // The vertex that is farthest from the mean of those that edges connect with v; the first of several.
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
    double farthest = 0;
    for (Index w : component) {
      m_cluster[w] = Rest_shape::none;
      farthest = (std::max)(farthest, (m_shape->points()[w] - centre).norm());
    }
    constexpr double rounding = 1e-9;
    Index result = Rest_shape::none;
    for (Index w : component)
      if ((m_shape->points()[w] - centre).norm() >= (1 - rounding) * farthest) result = (std::min)(result, w);
    return result;
  }

  Length length(Index edge) const
  {
    constexpr double longest = 1e18; // no sum of two overflows
    return Length(std::llround((std::min)(m_shape->lengths()[edge] / m_unit, longest)));
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
        const Length d = top.first + length(e);
        if (!(d < m_distance[w])) continue;
        m_distance[w] = d;
        if (d > radius_in_units)
          m_candidates.emplace(d, w);
        else {
          m_cluster[w] = cluster;
          queue.emplace(d, w);
        }
      }
    }
  }

  const Rest_shape* m_shape;
  double m_unit;
  std::vector<Length> m_distance;
  std::vector<Index> m_cluster;
  std::size_t m_number_of_clusters = 0;
  Queue m_candidates;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_VERTEX_CLUSTERS_H
