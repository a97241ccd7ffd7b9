// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SURFACE_VIEW_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SURFACE_VIEW_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Posed_surface.h>
#include <CGAL/Animated_mesh_features/Applications/internal/View_depth_map.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesViews

What a `ViewScore` is asked about: the surface in one frame, seen from infinitely far away in one direction. Hidden parts
are found by a depth map. Either side of the surface is seen: what has a border has an inside, too.
*/
class Surface_view
{
public:
  /// \cond SKIP_IN_MANUAL
  Surface_view(const Rest_shape& shape, const internal::Posed_surface& surface, const internal::View_depth_map& map,
               const Eigen::Vector3d& direction, bool from_above, std::size_t frame_rank)
    : m_shape(&shape)
    , m_surface(&surface)
    , m_map(&map)
    , m_direction(direction)
    , m_from_above(from_above)
    , m_frame_rank(frame_rank)
  {}
  /// \endcond

  /// which of the frames that are looked at this is, from 0.
  std::size_t frame_rank() const { return m_frame_rank; }

  /// the direction to the camera, a unit vector.
  const Eigen::Vector3d& direction() const { return m_direction; }

  /// the connectivity of the surface.
  const Rest_shape& shape() const { return *m_shape; }

  /// the radius of a sphere around the surface in this frame (length).
  double radius() const { return m_surface->radius; }

  /// the position of vertex `v` in this frame.
  Eigen::Vector3d point(std::size_t v) const
  {
    return m_surface->centre + m_surface->radius * m_surface->points[v].cast<double>();
  }

  /// the cosine of the angle under which the surface is seen at vertex `v`: 1 from straight above, 0 along it; negative
  /// where it is the back of the triangles that is turned to the camera.
  double cosine(std::size_t v) const { return m_surface->normals[v].dot(m_direction.cast<float>()); }

  /// how much of what surrounds vertex `v` is not hidden, from 0 to 1. Constant time.
  double visibility(std::size_t v) const
  {
    const Eigen::Vector3f& n = m_surface->normals[v];
    return double(m_map->visibility(m_surface->points[v], cosine(v) < 0 ? Eigen::Vector3f(-n) : n, m_from_above));
  }

  /// the area of the image of triangle `t`, hidden or not (squared length).
  double projected_area(std::size_t t) const
  {
    const Rest_shape::Triangle& c = m_shape->triangles()[t];
    const auto& p = m_surface->points;
    const Eigen::Vector3f n = (p[c[1]] - p[c[0]]).cross(p[c[2]] - p[c[0]]);
    return std::abs(double(n.dot(m_direction.cast<float>()))) / 2 * radius() * radius();
  }

private:
  const Rest_shape* m_shape;
  const internal::Posed_surface* m_surface;
  const internal::View_depth_map* m_map;
  Eigen::Vector3d m_direction;
  bool m_from_above;
  std::size_t m_frame_rank;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SURFACE_VIEW_H
