// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_FAST_MARCHING_H
#define CGAL_ANIMATED_MESH_FEATURES_FAST_MARCHING_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace Benchmark {

// Fast marching on a triangle mesh (Kimmel and Sethian 1998), bounded by a radius. A front of two vertices reaches the
// third as if it came from the point in their plane that has their distances, which is exact on flat surfaces. Corners
// with obtuse angles, which a front could reach late, are split by the vertex that is met when the triangles opposite
// are unfolded; this is done once for the mesh.
class Fast_marching
{
public:
  typedef CGAL::Animated_mesh_features::Rest_shape Rest_shape;
  typedef Rest_shape::Index Index;

  explicit Fast_marching(const Rest_shape& shape)
    : m_shape(shape)
    , m_distances(shape.number_of_vertices(), far)
    , m_is_final(shape.number_of_vertices(), 0)
  {
    std::vector<std::vector<Front>> fronts(shape.number_of_vertices());
    for (std::size_t t = 0; t < shape.triangles().size(); ++t)
      for (int i = 0; i < 3; ++i) add_corner(t, i, fronts);
    m_offsets.push_back(0);
    for (const auto& f : fronts) {
      m_fronts.insert(m_fronts.end(), f.begin(), f.end());
      m_offsets.push_back(m_fronts.size());
    }
  }

  // The vertices within the radius, nearest first.
  const std::vector<Index>& run(Index source, double radius)
  {
    for (Index v : m_touched) m_distances[v] = far, m_is_final[v] = 0;
    m_touched.assign(1, source);
    m_reached.clear();
    typedef std::pair<double, Index> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    m_distances[source] = 0;
    queue.emplace(0, source);
    while (!queue.empty()) {
      const Entry e = queue.top();
      queue.pop();
      const Index v = e.second;
      if (m_is_final[v] || e.first > m_distances[v]) continue; // an entry of before
      if (e.first > radius) break;
      m_is_final[v] = 1;
      m_reached.push_back(v);
      for (std::size_t i = m_offsets[v]; i < m_offsets[v + 1]; ++i) {
        const Front& f = m_fronts[i];
        if (m_is_final[f.target]) continue;
        double d = e.first + f.own_side;
        if (m_is_final[f.other]) d = (std::min)(d, through(f, e.first, m_distances[f.other]));
        if (!(d < m_distances[f.target])) continue;
        if (m_distances[f.target] == far) m_touched.push_back(f.target);
        m_distances[f.target] = d;
        queue.emplace(d, f.target);
      }
    }
    return m_reached;
  }

  // After run(), of those within the radius.
  double distance(Index v) const { return m_distances[v]; }

private:
  static constexpr double far = std::numeric_limits<double>::infinity();

  // A triangle of the vertex to which it is filed, another one, and the one that is to be reached.
  struct Front
  {
    Index other, target;
    double own_side, other_side, base; // |target - own|, |target - other|, |other - own|
  };

  // With the vertex at the origin and the other one on the x-axis.
  static double through(const Front& f, double own, double other)
  {
    const double around = (std::min)(own + f.own_side, other + f.other_side);
    const double x = (f.own_side * f.own_side + f.base * f.base - f.other_side * f.other_side) / (2 * f.base);
    const double y = std::sqrt((std::max)(0., f.own_side * f.own_side - x * x));
    const double source_x = (own * own + f.base * f.base - other * other) / (2 * f.base);
    const double squared_y = own * own - source_x * source_x;
    if (!(squared_y >= 0) || !(y > 0)) return around; // the distances are those of no point in this plane
    const double depth = std::sqrt(squared_y);
    const double crossing = source_x + (x - source_x) * depth / (y + depth);
    if (!(crossing >= 0 && crossing <= f.base)) return around;
    return std::hypot(x - source_x, y + depth);
  }

  static void add(Index a, Index b, Index target, double a_side, double b_side, double base,
                  std::vector<std::vector<Front>>& fronts)
  {
    fronts[a].push_back({b, target, a_side, b_side, base});
    fronts[b].push_back({a, target, b_side, a_side, base});
  }

  double length(Index a, Index b) const { return (m_shape.points()[a] - m_shape.points()[b]).norm(); }

  // The triangle on the other side of edge ab of triangle t, and its third vertex; none at the border.
  std::pair<Index, Index> across(Index t, Index a, Index b) const
  {
    for (Index u : m_shape.incident_triangles()[a]) {
      if (u == t) continue;
      const Rest_shape::Triangle& c = m_shape.triangles()[u];
      if (std::find(c.begin(), c.end(), b) == c.end()) continue;
      for (Index w : c)
        if (w != a && w != b) return {u, w};
    }
    return {Rest_shape::none, Rest_shape::none};
  }

  void add_corner(std::size_t triangle, int i, std::vector<std::vector<Front>>& fronts) const
  {
    const Rest_shape::Triangle& corners = m_shape.triangles()[triangle];
    const Index c = corners[std::size_t(i)], a = corners[std::size_t(i + 1) % 3], b = corners[std::size_t(i + 2) % 3];
    const double ca = length(c, a), cb = length(c, b), ab = length(a, b);
    if (!(ca > 0 && cb > 0 && ab > 0)) return;
    if (ca * ca + cb * cb >= ab * ab) return add(a, b, c, ca, cb, ab, fronts);

    // The plane of the triangle, with c at the origin and a on the x-axis; the vertices left and right of the edge that
    // is unfolded next.
    constexpr int most_unfoldings = 20;
    const double cosine = (ca * ca + cb * cb - ab * ab) / (2 * ca * cb);
    const Eigen::Vector2d at_a(ca, 0), at_b(cb * cosine, cb * std::sqrt((std::max)(0., 1 - cosine * cosine)));
    Index left = a, right = b, t = Index(triangle);
    Eigen::Vector2d at_left = at_a, at_right = at_b;
    for (int n = 0; n < most_unfoldings; ++n) {
      const std::pair<Index, Index> next = across(t, left, right);
      if (next.second == Rest_shape::none) break;
      const Eigen::Vector2d edge = at_right - at_left;
      const double base = edge.norm(), l = length(left, next.second), r = length(right, next.second);
      const double x = (l * l + base * base - r * r) / (2 * base);
      const double y = std::sqrt((std::max)(0., l * l - x * x));
      const Eigen::Vector2d along = edge / base, away(along[1], -along[0]);
      const Eigen::Vector2d at_next = at_left + x * along + y * away;
      const bool is_acute_to_a = at_next.dot(at_a) >= 0, is_acute_to_b = at_next.dot(at_b) >= 0;
      if (is_acute_to_a && is_acute_to_b) {
        add(a, next.second, c, ca, at_next.norm(), (at_next - at_a).norm(), fronts);
        add(next.second, b, c, at_next.norm(), cb, (at_next - at_b).norm(), fronts);
        return;
      }
      t = next.first;
      // the edge behind which lie the directions that are acute to both
      (is_acute_to_a ? left : right) = next.second;
      (is_acute_to_a ? at_left : at_right) = at_next;
    }
    add(a, b, c, ca, cb, ab, fronts);
  }

  const Rest_shape& m_shape;
  std::vector<std::size_t> m_offsets;
  std::vector<Front> m_fronts;
  std::vector<double> m_distances;
  std::vector<char> m_is_final;
  std::vector<Index> m_touched, m_reached;
};

} // namespace Benchmark

#endif // CGAL_ANIMATED_MESH_FEATURES_FAST_MARCHING_H
