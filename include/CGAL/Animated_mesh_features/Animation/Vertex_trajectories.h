// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_VERTEX_TRAJECTORIES_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_VERTEX_TRAJECTORIES_H

#include <CGAL/Animated_mesh_features/Animation/Frame_positions.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Field_memory.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

The positions of all vertices in all frames, in the form in which measures and writers see them: no descriptors, no
property maps; the coordinates of a vertex contiguous over the frames.

\tparam FT `float` or `double`.
*/
template <class FT>
struct Vertex_trajectories
{
  Spatio_temporal_field<FT> x; ///< `N x F` coordinates
  Spatio_temporal_field<FT> y; ///< `N x F` coordinates
  Spatio_temporal_field<FT> z; ///< `N x F` coordinates

  std::size_t number_of_vertices() const { return x.number_of_rows(); } ///< `N`
  std::size_t number_of_frames() const { return x.number_of_frames(); } ///< `F`

  /// the position of a vertex in a frame, both from 0.
  Rest_shape::Point point(std::size_t v, std::size_t f) const
  {
    return Rest_shape::Point(x(v, f), y(v, f), z(v, f));
  }

  /// the positions in frame `f`, from 0.
  Frame_positions<FT> frame(std::size_t f) const { return Frame_positions<FT>(x, y, z, f); }

  /// where the coordinates live.
  const std::shared_ptr<Field_memory>& memory() const { return x.memory(); }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_VERTEX_TRAJECTORIES_H
