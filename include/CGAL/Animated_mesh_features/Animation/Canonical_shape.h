// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_CANONICAL_SHAPE_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_CANONICAL_SHAPE_H

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Canonical_shape_builder.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage_scope.h>

#include <CGAL/tags.h>

#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

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
size); surfaces that are the same but for a bend to either side give the straight one. Else the rounds end when two in
succession gain less than a part in 400 of what the shape's lengths and angles differ from the averages by, in the sense
of squares. For a horse that gallops, edges then differ from those of the shape to which the rounds converge by 0.2 % and
angles by 0.2 degrees, root mean square, less than a fifth of what any surface has to differ from the averages by there.

\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag`, `CGAL::Parallel_tag` or `CGAL::Sequential_tag`.

\param connectivity edges and triangles; the points of this shape are not used.
\param trajectories the positions of all vertices in all frames.
\param visitor is asked in the middle, too; a model of `DetectionVisitor`, by default one that does nothing.

\returns a point for each vertex, in the mesh's unit of length. It depends on frames and connectivity only, bit for bit:
  not on the order of faces, nor on threads.

\throw Numerical_error if a factorisation fails, or edges are so long or short that fourth powers of their lengths leave
  the range of numbers.
\throw Cancelled if the visitor asks for it: within a tenth of a second.

Complexity: `O(F N)` for the averages; two sparse Cholesky factorisations, of as many rows as there are faces and vertices,
with `O(N log N)` entries, in `O(N^1.5)` time; and some 15 to 40 rounds of `O(N log N)`.
About 0.15 s for 8,400 vertices and 48 frames, 0.9 s for 33,700, 6 s for 135,000 and 10 frames, on one and a half cores of two.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class FT>
std::vector<Rest_shape::Point> canonical_shape(const Rest_shape& connectivity, const Vertex_trajectories<FT>& trajectories,
                                               Any_visitor visitor = Any_visitor())
{
  const internal::Stage_scope stage(visitor, Stage::REST_SHAPE);
  return internal::Canonical_shape_builder<ConcurrencyTag, FT>(connectivity, trajectories, visitor).build();
}

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

takes the canonical shape of all frames as rest shape of an animation.
\throw Numerical_error if the surface cannot be rebuilt.
\throw Cancelled if the visitor asks for it.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class TriangleMesh, class FT>
void set_canonical_rest_shape(Frame_sequence<TriangleMesh, FT>& animation, Any_visitor visitor = Any_visitor())
{
  animation.set_rest_shape(
      canonical_shape<ConcurrencyTag>(animation.rest_shape(), animation.trajectories(), visitor), Rest_unit::KEEP);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_CANONICAL_SHAPE_H
