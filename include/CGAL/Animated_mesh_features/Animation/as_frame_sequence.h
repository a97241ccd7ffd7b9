// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_AS_FRAME_SEQUENCE_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_AS_FRAME_SEQUENCE_H

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

converts any model of `MeshAnimation` to a `Frame_sequence`, the form in which measures read an animation. Its points are
read once, through its point maps, in `O(N F)` time and memory; the model vouches for the unit of its rest shape.

Functions such as `strain()` and `curvature()` take a `Frame_sequence`, so that a model is converted once and not by each
of them.

\tparam Animation a model of `MeshAnimation`.
\param animation is not kept but for its mesh, to which the result refers.
\param memory where the coordinates live, and what is computed from them.
\throw Input_error see `Frame_sequence`.
*/
template <class Animation>
Frame_sequence<typename Animation::Triangle_mesh, typename Animation::FT>
as_frame_sequence(const Animation& animation, const std::shared_ptr<Field_memory>& memory = Field_memory::heap())
{
  std::vector<decltype(animation.point_map(0))> maps;
  for (std::size_t f = 0; f < animation.number_of_frames(); ++f) maps.push_back(animation.point_map(f));
  Frame_sequence<typename Animation::Triangle_mesh, typename Animation::FT> sequence(
      animation.triangle_mesh(), maps, animation.frame_duration(), memory);
  sequence.set_rest_shape(animation.rest_point_map(), Rest_unit::KEEP);
  return sequence;
}

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

returns the sequence itself: for code that takes any model of `MeshAnimation`.
*/
template <class TriangleMesh, class FT>
const Frame_sequence<TriangleMesh, FT>& as_frame_sequence(const Frame_sequence<TriangleMesh, FT>& sequence)
{
  return sequence;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_AS_FRAME_SEQUENCE_H
