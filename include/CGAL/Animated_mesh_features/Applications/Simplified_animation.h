// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFIED_ANIMATION_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFIED_ANIMATION_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Applications/Vertex_binding.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

One level of detail of an animated mesh: triangles, and how their vertices follow those of the original. Its positions
in a frame are `binding.positions(trajectories.frame(f))`, at rest `binding.positions(rest.points())`, and in any other
animation of the same mesh just so.
*/
struct Animation_level
{
  typedef Rest_shape::Index Index; ///< of a vertex

  /// of vertices of this level, `0` to `M - 1`; as the original's triangles are oriented.
  std::vector<Rest_shape::Triangle> triangles;

  /// for each of them the triangle of the original, by rank in `Rest_shape::triangles()`, that it has been from the
  /// beginning: its corners are those in whose places the corners of that one have come.
  std::vector<Index> triangle_of;

  /// `M` rows.
  Vertex_binding binding;

  /// for each vertex of the original the vertex of this level that has taken its place; `Rest_shape::none` for one that
  /// belongs to no triangle. Levels are nested: what one vertex has taken in one level stays together in all coarser
  /// ones.
  std::vector<Index> vertex_of;
};

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

What `simplify_animation()` makes of an animation.
*/
struct Simplified_animation
{
  /// from fine to coarse, one for each number of vertices that was asked for.
  std::vector<Animation_level> levels;

  /// the frames whose quadrics were summed.
  std::vector<std::size_t> poses;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFIED_ANIMATION_H
