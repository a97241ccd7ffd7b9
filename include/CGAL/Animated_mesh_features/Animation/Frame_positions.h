// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_FRAME_POSITIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_FRAME_POSITIONS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

The positions of all vertices in one frame: a view of `Vertex_trajectories`, valid as long as these. Positions are read
from rows of frames, one number of a cache line each; whoever needs those of several frames goes vertex by vertex, through
`Vertex_trajectories` itself.

\tparam FT `float` or `double`.
*/
template <class FT>
class Frame_positions
{
public:
  /// a view of frame `frame`, from 0, of coordinates of `N x F` each.
  Frame_positions(const Spatio_temporal_field<FT>& x, const Spatio_temporal_field<FT>& y,
                  const Spatio_temporal_field<FT>& z, std::size_t frame)
    : m_x(&x)
    , m_y(&y)
    , m_z(&z)
    , m_frame(frame)
  {
  }

  /// `N`.
  std::size_t size() const { return m_x->number_of_rows(); }

  /// the position of vertex `v`, from 0.
  Rest_shape::Point operator[](std::size_t v) const
  {
    return Rest_shape::Point((*m_x)(v, m_frame), (*m_y)(v, m_frame), (*m_z)(v, m_frame));
  }

  /// a copy of all positions.
  std::vector<Rest_shape::Point> points() const
  {
    std::vector<Rest_shape::Point> points(size());
    for (std::size_t v = 0; v < points.size(); ++v) points[v] = (*this)[v];
    return points;
  }

private:
  const Spatio_temporal_field<FT>*m_x, *m_y, *m_z;
  std::size_t m_frame;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_FRAME_POSITIONS_H
