// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_CURVATURE_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_CURVATURE_H

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Deformation/Curvature_measures.h>
#include <CGAL/Animated_mesh_features/Deformation/internal/curvature_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

computes the curvature at every vertex in every frame, over geodesic balls of the rest shape.

Linear in the number of entries of `balls` times frames.

\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` or `CGAL::Sequential_tag`; the result is the same, bit for bit.
\tparam TriangleMesh, FT see `Frame_sequence`.
\tparam CurvatureMeasure a model of `CurvatureMeasure`.
\param animation the animation; of another model of `MeshAnimation`: see `as_frame_sequence()`.
\param balls a row for each vertex, ascending; see `geodesic_balls()`.
\param measure what is summed over a ball.
\returns a field of `N x F` curvatures, rows in the order of `vertices(mesh)`; 0 where a ball has no edge.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag,
          class TriangleMesh,
          class FT,
          class CurvatureMeasure = Mean_curvature_density>
Spatio_temporal_field<FT> curvature(const Frame_sequence<TriangleMesh, FT>& animation,
                                    const Compressed_rows& balls,
                                    const CurvatureMeasure& measure = CurvatureMeasure())
{
  Any_visitor visitor;
  return internal::curvature_rows(animation.rest_shape(), animation.trajectories(), balls, measure,
                                  Task_loop<ConcurrencyTag, Any_visitor>(visitor, Stage::CURVATURE));
}

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

computes \f$|\kappa(v, f) - \kappa(v, \mathrm{rest})|\f$ at every vertex in every frame; see `curvature()`.

\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` or `CGAL::Sequential_tag`; the result is the same, bit for bit.
\tparam TriangleMesh, FT see `Frame_sequence`.
\tparam CurvatureMeasure a model of `CurvatureMeasure`.
\param animation the animation; of another model of `MeshAnimation`: see `as_frame_sequence()`.
\param balls a row for each vertex, ascending; see `geodesic_balls()`.
\param measure what is summed over a ball.
\returns a field of `N x F` non-negative changes, without unit.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag,
          class TriangleMesh,
          class FT,
          class CurvatureMeasure = Mean_curvature_density>
Spatio_temporal_field<FT> curvature_change(const Frame_sequence<TriangleMesh, FT>& animation,
                                           const Compressed_rows& balls,
                                           const CurvatureMeasure& measure = CurvatureMeasure())
{
  Any_visitor visitor;
  return internal::curvature_change_rows(
      animation.rest_shape(), animation.trajectories(), balls, measure,
      Task_loop<ConcurrencyTag, Any_visitor>(visitor, Stage::CURVATURE));
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_CURVATURE_H
