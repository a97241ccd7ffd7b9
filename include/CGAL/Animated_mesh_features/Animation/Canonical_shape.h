// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_CANONICAL_SHAPE_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_CANONICAL_SHAPE_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Edge_measures.h>
#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_assembly.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_components.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_plan.h>
#include <CGAL/Animated_mesh_features/Animation/internal/nearest_rotation.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage_scope.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

template <class FT>
std::vector<Rest_shape::Point> assembled_canonical_shape(const Rest_shape& shape,
                                                         const Vertex_trajectories<FT>& trajectories)
{
  const Triangle_adjacency adjacency(shape);
  const std::vector<Surface_component> components = surface_components(shape);
  const Edge_measures mean = mean_edge_measures(shape, trajectories, adjacency);
  const std::vector<std::size_t> closest = closest_frames(shape, trajectories, adjacency, components, mean);

  std::vector<Rest_shape::Point> result(shape.number_of_vertices());
  std::vector<std::size_t> rank((std::max)(shape.number_of_vertices(), shape.triangles().size()));
  std::vector<Rest_shape::Point> normals;
  for (std::size_t f = 0; f < trajectories.number_of_frames(); ++f) {
    if (std::find(closest.begin(), closest.end(), f) == closest.end()) continue;
    const std::vector<Rest_shape::Point> points = trajectories.frame(f).points();
    triangle_normals(shape, adjacency, points, normals);
    for (std::size_t c = 0; c < components.size(); ++c) {
      if (closest[c] != f || components[c].triangles.empty()) continue;
      const std::vector<Rest_shape::Index>& vertices = components[c].vertices;
      std::vector<Rest_shape::Point> start, start_normals, target;
      for (Rest_shape::Index v : vertices) {
        start.push_back(points[v]);
        target.push_back(trajectories.point(v, 0));
      }
      for (Rest_shape::Index t : components[c].triangles) start_normals.push_back(normals[t]);
      const Surface_plan plan(shape, adjacency, components[c], mean, rank);
      const Surface_assembly assembly(plan, start, start_normals);
      const std::vector<Rest_shape::Point> placed = fitted_rigidly(assembly.points(), target);
      for (std::size_t i = 0; i < vertices.size(); ++i) result[vertices[i]] = placed[i];
    }
  }
  for (const Surface_component& component : components) {
    if (!component.triangles.empty()) continue;
    Rest_shape::Point sum = Rest_shape::Point::Zero();
    for (std::size_t f = 0; f < trajectories.number_of_frames(); ++f) sum += trajectories.point(component.vertices[0], f);
    result[component.vertices[0]] = sum / double(trajectories.number_of_frames());
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

The shape that an animation deforms about: the surface whose edge lengths and dihedral angles are, as closely as a
surface can have them, the averages over all frames (arithmetic means of lengths, circular means of angles).

A mean of positions would not do: where a part turns, it shrinks towards the axis. Lengths and angles do not change
under rotation, and they determine the surface up to a rigid motion \cgalCite{lipman2005}; Froehlich and Botsch blend
shapes by them \cgalCite{froehlich2011}. The surface is rebuilt as by Wang, Liu and Tong \cgalCite{wang2012}: one frame
for each triangle from a sparse linear system, then positions from another. As averages need not belong to any surface,
rounds of local and global steps follow until angles and lengths are in balance.

Each connected component is rebuilt on its own, starting from the frame of the animation in which it is closest to the
averages, and is moved rigidly to where it fits its first frame best. An isolated vertex is put to its mean position. A
triangle of zero height, or one that collapses in some frame, continues its neighbours.

If all frames are the same surface up to rigid motions, the result is that surface to rounding (some `1e-11` of its
size); surfaces that are the same but for a bend to either side give the straight one.

\param connectivity edges and triangles; the points of this shape are not used.
\param trajectories the positions of all vertices in all frames.
\returns a point for each vertex, in the mesh's unit of length. It depends on frames and connectivity only, bit for bit:
  not on the order of faces, nor on threads, of which it uses one.

\param visitor is asked in the middle, too; a model of `DetectionVisitor`, by default one that does nothing.

\throw Numerical_error if a factorisation fails, as with coordinates whose squares overflow.
\throw Cancelled if the visitor asks for it: within a tenth of a second, but for the two factorisations.

Complexity: `O(F N)` for the averages, two sparse Cholesky factorisations, of size 3 x faces and of size N, with
`O(N log N)` entries, and some 50 to 200 rounds of `O(N log N)`.
About 1.5 s for 8,400 vertices and 48 frames, 7 s for 33,700; 35 s and 0.9 GB for 100,000 and 10 frames.
*/
template <class FT>
std::vector<Rest_shape::Point> canonical_shape(const Rest_shape& connectivity, const Vertex_trajectories<FT>& trajectories,
                                               Any_visitor visitor = Any_visitor())
{
  std::vector<Rest_shape::Point> result;
  const internal::Stage_scope stage(visitor, Stage::REST_SHAPE);
  const Task_loop<CGAL::Sequential_tag, Any_visitor> loop(visitor, Stage::REST_SHAPE);
  loop(1, [&](std::size_t) { result = internal::assembled_canonical_shape(connectivity, trajectories); });
  return result;
}

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

takes the canonical shape of all frames as rest shape of an animation.
\throw Numerical_error if the surface cannot be rebuilt.
\throw Cancelled if the visitor asks for it.
*/
template <class TriangleMesh, class FT>
void set_canonical_rest_shape(Frame_sequence<TriangleMesh, FT>& animation, Any_visitor visitor = Any_visitor())
{
  animation.set_rest_shape(canonical_shape(animation.rest_shape(), animation.trajectories(), visitor), Rest_unit::KEEP);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_CANONICAL_SHAPE_H
