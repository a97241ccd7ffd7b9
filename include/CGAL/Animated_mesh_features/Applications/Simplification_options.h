// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFICATION_OPTIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFICATION_OPTIONS_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

How an animated mesh is simplified. The defaults are those that were measured, see the manual.
*/
struct Simplification_options
{
  /// the numbers of vertices that are wanted, one for each level of detail, each smaller than the one before. A level
  /// has more where nothing else can be collapsed: without changing the topology, or without turning a triangle over.
  std::vector<std::size_t> vertices;

  /// the most poses whose quadrics are summed. An animation of up to as many frames is taken whole, of a longer one
  /// `choose_poses()` chooses. Memory and time are proportional to it: 80 bytes for each vertex and pose.
  std::size_t poses = 32;

  /// frames that are poses in any case, in the order of their importance: those of features, for instance.
  std::vector<std::size_t> preferred_poses;

  /// how much the distance from the line along the normal through a vertex counts, relative to that from its triangles'
  /// planes: keeps the vertices of flat regions where they are dense, and triangles well shaped.
  double line_weight = 1e-3;

  /// how much the distance from the plane that stands on a border edge counts, per squared length of the edge,
  /// relative to that from the surface, per area.
  double border_weight = 1;

  /// the least cosine of the angle by which the normal of a triangle may turn in a collapse, in every frame and at rest,
  /// if it does not turn to where the original around it looks; not negative. The larger, the fewer collapses are possible.
  double least_cosine = .2;

  /// the most vertices of the original that one vertex follows, at least 1. Four are needed to follow an affine
  /// motion from outside of the surface.
  std::size_t support = 8;

  /// how often the places of a level's vertices are refined by the distances between both surfaces, see
  /// `Animation_collapse::refine()`; coarser levels go on from there. On the way to a level, whenever the number of vertices
  /// has halved, a third as often, rounded up. 0: never.
  std::size_t refinements = 6;

  /// vertices that stay, by rank in `vertices(mesh)`, in any order.
  std::vector<std::size_t> fixed_vertices;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFICATION_OPTIONS_H
