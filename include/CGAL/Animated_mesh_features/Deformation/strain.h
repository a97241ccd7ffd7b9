// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_STRAIN_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_STRAIN_H

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Deformation/Strain_measures.h>
#include <CGAL/Animated_mesh_features/Deformation/Triangle_weights.h>
#include <CGAL/Animated_mesh_features/Deformation/internal/strain_fields.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

computes the strain of every triangle in every frame with respect to the rest shape.

Linear in triangles x frames.

\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` or `CGAL::Sequential_tag`; the result is the same, bit for bit.
\tparam TriangleMesh, FT see `Frame_sequence`.
\tparam StrainMeasure a model of `StrainMeasure`.
\param animation the animation; of another model of `MeshAnimation`: see `as_frame_sequence()`.
\param measure what the principal stretches become.
\returns a field of `number of triangles x F` strains without unit, rows in the order of `faces(mesh)`. Rows of
  triangles that are degenerate at rest are zero.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag,
          class TriangleMesh,
          class FT,
          class StrainMeasure = Hencky_strain>
Spatio_temporal_field<FT> triangle_strain(const Frame_sequence<TriangleMesh, FT>& animation,
                                          const StrainMeasure& measure = StrainMeasure())
{
  Any_visitor visitor;
  return internal::triangle_strain_rows(animation.rest_shape(), animation.trajectories(), measure,
                                        Task_loop<ConcurrencyTag, Any_visitor>(visitor, Stage::STRAIN));
}

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

computes the strain at every vertex in every frame: the weighted mean of the strains of the triangles around it.
Triangles that are degenerate at rest are left out; a vertex without others has strain 0. Linear in triangles x frames.

\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` or `CGAL::Sequential_tag`; the result is the same, bit for bit.
\tparam TriangleMesh, FT see `Frame_sequence`.
\tparam StrainMeasure a model of `StrainMeasure`.
\param animation the animation; of another model of `MeshAnimation`: see `as_frame_sequence()`.
\param measure what the principal stretches become.
\param weights of the triangles in the mean.
\returns a field of `N x F` strains without unit, rows in the order of `vertices(mesh)`.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag,
          class TriangleMesh,
          class FT,
          class StrainMeasure = Hencky_strain>
Spatio_temporal_field<FT> strain(const Frame_sequence<TriangleMesh, FT>& animation,
                                 const StrainMeasure& measure = StrainMeasure(),
                                 Triangle_weights weights = Triangle_weights::REST_AREA)
{
  Any_visitor visitor;
  return internal::vertex_strain_rows(animation.rest_shape(), animation.trajectories(), measure, weights,
                                      Task_loop<ConcurrencyTag, Any_visitor>(visitor, Stage::STRAIN));
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_STRAIN_H
