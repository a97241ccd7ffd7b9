// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_CLUSTER_BALL_FINDER_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_CLUSTER_BALL_FINDER_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Cluster_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Heat_distances.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Path_lengths.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Surface_patch.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/ball_reach.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Finds the balls of one cluster after the other, by the heat method's distance clamped to [Euclid, shortest path along
// edges]: both are bounds of the geodesic distance, and the heat method's own error a few edges from the source (6 to
// 8 %) often lies outside of them. One for each thread.
class Cluster_ball_finder
{
public:
  typedef Rest_shape::Index Index;
  typedef Source_pack::Array Array;

  // margin: how far the patch reaches beyond the balls; extent: an upper bound of the distance between vertices of a
  // cluster
  Cluster_ball_finder(const Rest_shape& shape, double radius, double margin, double extent)
    : m_shape(&shape)
    , m_radius(radius)
    , m_margin(margin)
    , m_extent(extent)
    , m_dijkstra(shape)
    , m_patch(shape)
  {}

  template <class Sources>
  Cluster_balls operator()(const Sources& cluster)
  {
    m_patch.set(m_dijkstra.run(cluster, m_radius + m_margin));
    m_heat.set(m_patch, time_scale());
    std::vector<Index> sources(cluster.begin(), cluster.end());
    group(sources.data(), sources.data() + sources.size());
    const std::size_t n = m_patch.number_of_vertices();
    m_masks.clear();
    for (std::size_t first = 0; first < sources.size(); first += Source_pack::size) {
      const std::size_t last = (std::min)(first + Source_pack::size, sources.size());
      m_sources.clear();
      for (std::size_t s = first; s < last; ++s) m_sources.push_back(m_patch.number(sources[s]));
      m_masks.resize(m_masks.size() + n, 0);
      find(&m_masks[m_masks.size() - n]);
    }
    return Cluster_balls(sources, m_patch.vertices(), m_masks);
  }

private:
  // The square root of the heat method's time step: the mean length of an edge of the patch. Less, and the heat spreads
  // in steps along edges; more, and it forgets the source. The mean of the patch rather than of the mesh, as lengths may
  // vary over the mesh. Heat falls to 1 / e over this length; in a patch of very many edges it is longer, or the squares
  // of the gradients would underflow.
  double time_scale() const
  {
    constexpr double most_decays = 300; // exp(-2 * 300) is 1e-261
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t v = 0; v < m_patch.number_of_vertices(); ++v)
      for (const Surface_patch::Neighbour& w : m_patch.neighbours(v)) {
        sum += w.length;
        ++count;
      }
    return (std::max)(count > 0 ? sum / double(count) : 0., (m_extent + m_radius + m_margin) / most_decays);
  }

  // Sorts the sources so that those of a group, a pack of them, are close together.
  void group(Index* first, Index* last) const
  {
    const std::size_t groups = (std::size_t(last - first) + Source_pack::size - 1) / Source_pack::size;
    if (groups <= 1) return;
    const auto& points = m_shape->points();
    Rest_shape::Point low = points[*first], high = low;
    for (const Index* s = first; s != last; ++s) {
      low = low.cwiseMin(points[*s]);
      high = high.cwiseMax(points[*s]);
    }
    int axis;
    (high - low).maxCoeff(&axis);
    Index* middle = first + groups / 2 * Source_pack::size;
    std::nth_element(first, middle, last, [&](Index a, Index b) {
      return points[a][axis] < points[b][axis] || (points[a][axis] == points[b][axis] && a < b);
    });
    group(first, middle);
    group(middle, last);
  }

  // The balls of m_sources, of the patch: a bit for each in the masks of the patch's vertices.
  void find(Cluster_balls::Mask* masks)
  {
    find_near();
    m_heat.run(m_sources, m_near);
    sort_near();
    m_paths.run(m_patch, m_sources, m_near);
    unsigned cut_off = 0;
    for (Index v : m_near) {
      const Array& path = m_paths.length(v);
      const Array heat = m_heat.distance(v), inside = inner_distance(heat, path);
      unsigned mask = 0;
      for (std::size_t l = 0; l < m_sources.size(); ++l) {
        // as numbers: branches would be mispredicted
        const unsigned near = is_near(v, l, m_squared_distance[v][l]), in_heat = heat[l] <= m_radius;
        mask |= (unsigned(inside[l] <= m_radius) & near) << l;
        cut_off |= (unsigned(path[l] > ball_reach * m_radius) & in_heat & near) << l;
      }
      masks[v] = Cluster_balls::Mask(mask);
    }
    for (std::size_t l = 0; l < m_sources.size(); ++l)
      if (cut_off >> l & 1) find_with_detours(l, masks);
  }

  // Collects the vertices that are in a ball by their distance in space.
  void find_near()
  {
    for (int i = 0; i < 3; ++i)
      for (std::size_t l = 0; l < Source_pack::size; ++l) // entries to spare repeat a source
        m_x[i][l] = m_patch.points()[m_sources[l < m_sources.size() ? l : 0]][i];
    m_near.clear();
    m_squared_distance.resize(m_patch.number_of_vertices());
    const double bound = m_radius * m_radius * (1 + rounding);
    for (std::size_t v = 0; v < m_patch.number_of_vertices(); ++v) {
      const Rest_shape::Point& p = m_patch.points()[v];
      const Array x = m_x[0] - p[0], y = m_x[1] - p[1], z = m_x[2] - p[2];
      const Array d = x * x + y * y + z * z;
      m_squared_distance[v] = d;
      if (d.minCoeff() <= bound) m_near.push_back(Index(v));
    }
  }

  // Near the bound, as others compute the distance: in regular meshes, vertices lie on it.
  bool is_near(Index v, std::size_t s, double squared_distance) const
  {
    const double bound = m_radius * m_radius;
    if (squared_distance < bound * (1 - rounding)) return true;
    if (squared_distance > bound * (1 + rounding)) return false;
    return is_near(v, s);
  }
  bool is_near(Index v, std::size_t s) const
  {
    return (m_patch.points()[v] - m_patch.points()[m_sources[s]]).norm() <= m_radius;
  }

  void sort_near()
  {
    m_keys.clear();
    for (Index v : m_near) {
      const double key = m_heat.distance(v).sum();
      m_keys.emplace_back(key < Path_lengths::far ? key : Path_lengths::far, v);
    }
    std::sort(m_keys.begin(), m_keys.end());
    for (std::size_t i = 0; i < m_near.size(); ++i) m_near[i] = m_keys[i].second;
  }

  static Array inner_distance(const Array& heat, const Array& path)
  {
    return path.min(heat.max(path * (1 / ball_reach)));
  }

  void find_with_detours(std::size_t s, Cluster_balls::Mask* masks)
  {
    const std::array<Index, 1> source = {{m_patch.vertices()[m_sources[s]]}};
    for (Index w : m_dijkstra.run(source, ball_reach * m_radius)) {
      const Index v = m_patch.number(w);
      if (v == Surface_patch::none || !is_near(v, s)) continue;
      if (m_dijkstra.distance(w) <= m_radius || m_heat.distance(v)[s] <= m_radius)
        masks[v] = Cluster_balls::Mask(masks[v] | 1u << s);
    }
  }

  static constexpr double rounding = 1e-12; // far above that of a sum of three squares

  const Rest_shape* m_shape;
  double m_radius, m_margin, m_extent;
  Bounded_dijkstra m_dijkstra;
  Surface_patch m_patch;
  Heat_distances m_heat;
  Path_lengths m_paths;
  std::vector<Index> m_sources, m_near; // of the patch
  Array m_x[3];                         // of the sources
  Source_pack::Rows m_squared_distance;
  std::vector<std::pair<double, Index>> m_keys;
  std::vector<Cluster_balls::Mask> m_masks;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_CLUSTER_BALL_FINDER_H
