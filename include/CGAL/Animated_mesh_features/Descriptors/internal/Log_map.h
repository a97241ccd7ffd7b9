// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_INTERNAL_LOG_MAP_H
#define CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_INTERNAL_LOG_MAP_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The normals of all vertices: means over triangles, weighted by area; zero without triangles.
inline std::vector<Rest_shape::Point> vertex_normals(const Rest_shape& shape)
{
  typedef Rest_shape::Point Point;
  std::vector<Point> normals(shape.number_of_vertices(), Point(0, 0, 0));
  for (Rest_shape::Index t : shape.ordered_triangles()) {
    const Rest_shape::Triangle& c = shape.triangles()[t];
    const Point& p = shape.points()[c[0]];
    const Point n = (shape.points()[c[1]] - p).cross(shape.points()[c[2]] - p);
    for (Rest_shape::Index v : c) normals[v] += n;
  }
  for (Point& n : normals) {
    const double length = n.norm();
    if (length > 0) n /= length;
  }
  return normals;
}

// v, turned as the unit vector `from` is when it is turned to the unit vector `to` on the shortest way.
inline Rest_shape::Point turned(const Rest_shape::Point& v, const Rest_shape::Point& from, const Rest_shape::Point& to)
{
  const Rest_shape::Point w = from.cross(to);
  const double c = from.dot(to);
  if (c < -0.999) return -v; // opposite: any way is as good
  return v + w.cross(v) + w.cross(w.cross(v)) / (1 + c);
}

// Coordinates of vertices around one of them in its tangent plane: the discrete exponential map of Schmidt, Grimm and
// Wyvill (2006), whose frames travel along shortest paths, with means over all neighbours that are nearer to the centre
// (Schmidt 2013) instead of the nearest one alone. O(k log k) for k vertices.
class Log_map
{
public:
  typedef Rest_shape::Index Index;
  typedef Rest_shape::Point Point;

  Log_map(const Rest_shape& shape, const std::vector<Point>& normals)
    : m_shape(&shape)
    , m_normals(&normals)
    , m_paths(shape)
    , m_x(shape.number_of_vertices())
    , m_y(shape.number_of_vertices())
    , m_axis(shape.number_of_vertices())
    , m_is_known(shape.number_of_vertices(), 0)
  {}

  // The vertices within `limit` of the centre, along edges, nearest first.
  const std::vector<Index>& run(Index centre, double limit)
  {
    const std::vector<Index>& reached = m_paths.run(std::array<Index, 1>{{centre}}, limit);
    for (Index v : reached) {
      if (v == centre)
        begin(v);
      else
        go_on(v);
      m_is_known[v] = 1;
    }
    for (Index v : reached) m_is_known[v] = 0;
    return reached;
  }

  double x(Index v) const { return m_x[v]; }
  double y(Index v) const { return m_y[v]; }

  // The two axes where the frame has come to, tangent to the surface.
  const Point& first_axis(Index v) const { return m_axis[v]; }
  Point second_axis(Index v) const { return (*m_normals)[v].cross(m_axis[v]); }

private:
  // any tangent
  static Point tangent(const Point& n)
  {
    Point smallest(0, 0, 0);
    Eigen::Index i = 0;
    n.cwiseAbs().minCoeff(&i);
    smallest[i] = 1;
    const Point t = smallest - smallest.dot(n) * n;
    return t / t.norm();
  }

  void begin(Index v)
  {
    m_x[v] = m_y[v] = 0;
    m_axis[v] = tangent((*m_normals)[v]);
  }

  void go_on(Index v)
  {
    const Point& n = (*m_normals)[v];
    double x = 0, y = 0, sum = 0;
    Point axis(0, 0, 0);
    for (Index p : m_shape->neighbours()[v]) {
      if (m_is_known[p] == 0) continue;
      const Point& m = (*m_normals)[p];
      const Point step = m_shape->points()[v] - m_shape->points()[p];
      const double length = step.norm();
      if (!(length > 0)) { // the same place
        m_x[v] = m_x[p];
        m_y[v] = m_y[p];
        m_axis[v] = tangent_near(turned(m_axis[p], m, n), n);
        return;
      }
      Point flat = step - step.dot(m) * m;
      const double flat_length = flat.norm();
      if (flat_length > 0) flat *= length / flat_length;
      const double weight = 1 / length;
      x += weight * (m_x[p] + flat.dot(m_axis[p]));
      y += weight * (m_y[p] + flat.dot(second_axis(p)));
      axis += weight * turned(m_axis[p], m, n);
      sum += weight;
    }
    m_x[v] = x / sum;
    m_y[v] = y / sum;
    m_axis[v] = tangent_near(axis, n);
  }

  static Point tangent_near(const Point& axis, const Point& n)
  {
    const Point t = axis - axis.dot(n) * n;
    const double length = t.norm();
    return length > 1e-9 ? Point(t / length) : tangent(n);
  }

  const Rest_shape* m_shape;
  const std::vector<Point>* m_normals;
  Bounded_dijkstra m_paths;
  std::vector<double> m_x, m_y;
  std::vector<Point> m_axis;
  std::vector<char> m_is_known;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_INTERNAL_LOG_MAP_H
