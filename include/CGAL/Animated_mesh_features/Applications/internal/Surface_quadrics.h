// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_SURFACE_QUADRICS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_SURFACE_QUADRICS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_positions.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_quadrics.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The quadrics that a surface gives its vertices, in each pose: of the planes of their triangles, by area, of the lines
// along their normals, and of the planes that stand on border edges.
class Surface_quadrics
{
public:
  // `line_weight`: of the area at a vertex; `border_weight`: of the squared length of an edge. Arguments are kept by
  // reference.
  Surface_quadrics(const Rest_shape& rest, const Pose_positions& positions, double line_weight, double border_weight)
    : m_rest(&rest)
    , m_positions(&positions)
    , m_line_weight(line_weight)
    , m_border_weight(border_weight)
  {}

  // Those of a vertex, which are zero before; `weight`: how much its surface matters in the pose.
  void add_to(Pose_quadrics& quadrics, std::size_t v, std::size_t pose, double weight) const
  {
    Point normal(0, 0, 0);
    double area = 0;
    for (Index t : m_rest->incident_triangles()[v]) {
      const Rest_shape::Triangle& triangle = m_rest->triangles()[t];
      const Point a = point(triangle[0], pose);
      const Point n = (point(triangle[1], pose) - a).cross(point(triangle[2], pose) - a);
      const double length = n.norm();
      if (!(length > 0)) continue;
      quadrics.add_plane(v, pose, n / length, a, weight * length / 6); // a third of its area
      normal += n;
      area += length / 6;
    }
    const double length = normal.norm();
    if (length > 0) quadrics.add_line(v, pose, normal / length, point(Index(v), pose), weight * m_line_weight * area);
    if (m_rest->is_border(v)) add_border(quadrics, v, pose, weight);
  }

private:
  typedef Rest_shape::Index Index;
  typedef Rest_shape::Point Point;

  Point point(Index v, std::size_t pose) const
  {
    const std::array<double, 3> x = m_positions->point(v, pose);
    return Point(x[0], x[1], x[2]);
  }

  // the plane through a border edge that stands on its triangle
  void add_border(Pose_quadrics& quadrics, std::size_t v, std::size_t pose, double weight) const
  {
    for (Index e : m_rest->incident_edges()[v]) {
      const Rest_shape::Edge& edge = m_rest->edges()[e];
      if (!edge.is_border()) continue;
      const Point a = point(edge.source, pose), along = point(edge.target, pose) - a;
      const Index third = edge.left == Rest_shape::none ? edge.right : edge.left;
      const Point n = along.cross(along.cross(point(third, pose) - a));
      const double length = n.norm();
      if (length > 0) quadrics.add_plane(v, pose, n / length, a, weight * m_border_weight * along.squaredNorm() / 2);
    }
  }

  const Rest_shape* m_rest;
  const Pose_positions* m_positions;
  double m_line_weight, m_border_weight;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_SURFACE_QUADRICS_H
