// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TRIANGLE_TREE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TRIANGLE_TREE_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The point of a triangle that is nearest to p, by the region of the plane in which p lies (C. Ericson, Real-Time
// Collision Detection, 2005, sect. 5.1.5).
inline Rest_shape::Point nearest_in_triangle(const Rest_shape::Point& p, const Rest_shape::Point& a,
                                             const Rest_shape::Point& b, const Rest_shape::Point& c)
{
  typedef Rest_shape::Point Point;
  const Point ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double ab_ap = ab.dot(ap), ac_ap = ac.dot(ap);
  if (ab_ap <= 0 && ac_ap <= 0) return a;
  const double ab_bp = ab.dot(bp), ac_bp = ac.dot(bp);
  if (ab_bp >= 0 && ac_bp <= ab_bp) return b;
  const double vc = ab_ap * ac_bp - ab_bp * ac_ap;
  if (vc <= 0 && ab_ap >= 0 && ab_bp <= 0) return a + (ab_ap / (ab_ap - ab_bp)) * ab;
  const double ab_cp = ab.dot(cp), ac_cp = ac.dot(cp);
  if (ac_cp >= 0 && ab_cp <= ac_cp) return c;
  const double vb = ab_cp * ac_ap - ab_ap * ac_cp;
  if (vb <= 0 && ac_ap >= 0 && ac_cp <= 0) return a + (ac_ap / (ac_ap - ac_cp)) * ac;
  const double va = ab_bp * ac_cp - ab_cp * ac_bp, along_b = ac_bp - ab_bp, along_c = ab_cp - ac_cp;
  if (va <= 0 && along_b >= 0 && along_c >= 0) return b + (along_b / (along_b + along_c)) * (c - b);
  const double sum = va + vb + vc;
  if (!(sum > 0)) return a; // a triangle without area whose sides were all missed by rounding
  return a + (vb / sum) * ab + (vc / sum) * ac;
}

// The triangles of a surface that moves, in a tree of boxes: its structure is made once, its boxes follow in linear
// time. What was nearest a frame ago is where to look first.
class Triangle_tree
{
public:
  typedef Rest_shape::Index Index;
  typedef Rest_shape::Point Point;
  typedef Rest_shape::Triangle Triangle;

  struct Nearest
  {
    double square = std::numeric_limits<double>::infinity(); // of the distance
    Index triangle = Rest_shape::none;
  };

  // `triangles` are kept by reference.
  Triangle_tree(const std::vector<Triangle>& triangles, const std::vector<Point>& points)
    : m_triangles(&triangles)
    , m_order(triangles.size())
  {
    std::iota(m_order.begin(), m_order.end(), Index(0));
    std::vector<Point> centres;
    for (const Triangle& t : triangles) centres.push_back((points[t[0]] + points[t[1]] + points[t[2]]) / 3);
    if (!triangles.empty()) divide(0, Index(triangles.size()), centres);
    follow(points);
  }

  // moves the vertices; kept by reference until the next time
  void follow(const std::vector<Point>& points)
  {
    m_points = &points;
    for (std::size_t i = m_nodes.size(); i-- > 0;) { // children come after their parents
      Node& node = m_nodes[i];
      if (node.second != 0) {
        node.low = m_nodes[i + 1].low.cwiseMin(m_nodes[node.second].low);
        node.high = m_nodes[i + 1].high.cwiseMax(m_nodes[node.second].high);
        continue;
      }
      node.low = node.high = points[(*m_triangles)[m_order[node.begin]][0]];
      for (Index k = node.begin; k < node.end; ++k)
        for (Index v : (*m_triangles)[m_order[k]]) {
          node.low = node.low.cwiseMin(points[v]);
          node.high = node.high.cwiseMax(points[v]);
        }
    }
  }

  // The triangle that is nearest to p. `guess`: one that may be it, or `none`.
  Nearest nearest(const Point& p, Index guess) const
  {
    Nearest best;
    if (guess != Rest_shape::none) try_triangle(p, guess, best);
    Index stack[64];
    std::size_t size = 0;
    if (!m_nodes.empty()) stack[size++] = 0;
    while (size > 0) {
      const Index i = stack[--size];
      const Node& node = m_nodes[i];
      if (!(distance(p, node) < best.square)) continue;
      if (node.second == 0) {
        for (Index k = node.begin; k < node.end; ++k) try_triangle(p, m_order[k], best);
        continue;
      }
      Index near = i + 1, far = node.second;
      if (distance(p, m_nodes[far]) < distance(p, m_nodes[near])) std::swap(near, far);
      stack[size++] = far;
      stack[size++] = near;
    }
    return best;
  }

private:
  struct Node
  {
    Point low, high;
    Index begin = 0, end = 0; // of a leaf
    Index second = 0;         // the second child; the first is next; 0: a leaf
  };

  static constexpr Index leaf = 4; // triangles; halves keep the depth below 32

  Index divide(Index begin, Index end, const std::vector<Point>& centres)
  {
    const Index i = Index(m_nodes.size());
    m_nodes.emplace_back();
    m_nodes[i].begin = begin;
    m_nodes[i].end = end;
    if (end - begin <= leaf) return i;
    Point low = centres[m_order[begin]], high = low;
    for (Index k = begin; k < end; ++k) {
      low = low.cwiseMin(centres[m_order[k]]);
      high = high.cwiseMax(centres[m_order[k]]);
    }
    const Point extent = high - low;
    const int axis = extent[0] >= extent[1] && extent[0] >= extent[2] ? 0 : extent[1] >= extent[2] ? 1 : 2;
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(m_order.begin() + begin, m_order.begin() + middle, m_order.begin() + end, [&](Index a, Index b) {
      return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
    });
    divide(begin, middle, centres);
    const Index second = divide(middle, end, centres);
    m_nodes[i].second = second;
    return i;
  }

  void try_triangle(const Point& p, Index t, Nearest& best) const
  {
    const Triangle& v = (*m_triangles)[t];
    const double square =
        (p - nearest_in_triangle(p, (*m_points)[v[0]], (*m_points)[v[1]], (*m_points)[v[2]])).squaredNorm();
    if (square < best.square) best = {square, t};
  }

  static double distance(const Point& p, const Node& node)
  {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double d = (std::max)((std::max)(node.low[axis] - p[axis], p[axis] - node.high[axis]), 0.);
      sum += d * d;
    }
    return sum;
  }

  const std::vector<Triangle>* m_triangles;
  const std::vector<Point>* m_points = nullptr;
  std::vector<Index> m_order;
  std::vector<Node> m_nodes;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TRIANGLE_TREE_H
