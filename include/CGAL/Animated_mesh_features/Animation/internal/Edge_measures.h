// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_EDGE_MEASURES_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_EDGE_MEASURES_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_components.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// What does not change when a surface moves rigidly, and determines it up to a rigid motion: for each edge its length
// and the angle between its triangles, as unit vector (cos, sin). The angle is the one that turns the normal of the
// left triangle into that of the right one about the direction from source to target; positive where convex.
struct Edge_measures
{
  std::vector<double> lengths;
  std::vector<Eigen::Vector2d> angles; // zero where there is none: at borders, and at edges of length zero
};

// A height that is below this share of the longest side is lost in rounding when it follows from lengths.
inline double least_relative_height()
{
  return std::sqrt(std::numeric_limits<double>::epsilon());
}

// One triangle or edge in one frame: what the loops over frames do for all that has height.
template <class FT>
class Surface_frame
{
  typedef Rest_shape::Point Point;

public:
  Surface_frame(const Rest_shape& shape, const Triangle_adjacency& adjacency,
                const Vertex_trajectories<FT>& trajectories, std::size_t frame)
    : m_shape(shape)
    , m_adjacency(adjacency)
    , m_trajectories(trajectories)
    , m_frame(frame)
  {}

  // A triangle without height has no unit normal of its own: it continues its neighbours, turned about its longest edge
  // so as to be perpendicular to it.
  Point normal(std::size_t t) const
  {
    Point n = doubled_area(t);
    if (!n.isZero(0)) return n.normalized();
    const Rest_shape::Triangle& v = m_shape.triangles()[t];
    Point axis = Point::Zero();
    for (unsigned k = 0; k < 3; ++k) {
      const Rest_shape::Index g = m_adjacency.neighbour(t, k);
      if (g != Rest_shape::none) n += doubled_area(g);
      const Point side = point(v[(k + 1) % 3]) - point(v[k]);
      if (side.squaredNorm() > axis.squaredNorm()) axis = side;
    }
    axis.normalize(); // leaves a zero vector alone
    n -= axis * axis.dot(n);
    if (!(n.norm() > 0)) n = axis.isZero() ? Point(Point::UnitZ()) : Point(axis.unitOrthogonal());
    return n.normalized();
  }

  // As unit vector, or zero.
  Eigen::Vector2d angle(std::size_t e) const
  {
    const Rest_shape::Edge& edge = m_shape.edges()[e];
    const Point d = point(edge.target) - point(edge.source);
    const double length = d.norm();
    if (!m_adjacency.is_interior(e) || !(length > 0)) return Eigen::Vector2d::Zero();
    const Point l = normal(m_adjacency.sides[e][0].triangle), r = normal(m_adjacency.sides[e][1].triangle);
    const Eigen::Vector2d angle(l.dot(r), l.cross(r).dot(d) / length);
    const double norm = angle.norm();
    return norm > 0 ? Eigen::Vector2d(angle / norm) : Eigen::Vector2d(Eigen::Vector2d::Zero());
  }

private:
  Point point(std::size_t v) const { return m_trajectories.point(v, m_frame); }

  // As vector; zero without height.
  Point doubled_area(std::size_t t) const
  {
    const Rest_shape::Triangle& v = m_shape.triangles()[t];
    const Point a = point(v[1]) - point(v[0]), b = point(v[2]) - point(v[0]), n = a.cross(b);
    const double longest = (std::max)({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    return n.norm() > least_relative_height() * longest ? n : Point(Point::Zero());
  }

  const Rest_shape& m_shape;
  const Triangle_adjacency& m_adjacency;
  const Vertex_trajectories<FT>& m_trajectories;
  std::size_t m_frame;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_EDGE_MEASURES_H
