// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_CURVATURE_H
#define CGAL_ANIMATED_MESH_FEATURES_CURVATURE_H

#include <CGAL/Animated_mesh_features/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Curvature_measures.h>
#include <CGAL/Animated_mesh_features/Heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Visitor.h>
#include <CGAL/Animated_mesh_features/internal/Animation_access.h>
#include <CGAL/Animated_mesh_features/internal/curvature_rows.h>
#include <CGAL/Animated_mesh_features/internal/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesBalls

the default radius \f$r = \min(\max(0.045\,D, 3h), 8h)\f$ of the geodesic balls (length): 4.5 % of the diameter of the
rest shape, but at least 3 mean edge lengths, below which balls contain too few edges (at 1 edge length, 8 % of the
balls of a scanned horse contain none), and at most 8, some 230 vertices a ball: memory and time stay linear in the
number of vertices. (Of meshes beyond some 30,000 vertices the curvature therefore depends on the density; to compare
such, give the radius.)

With smaller balls curvature depends on the mesh: between a horse of 8,431 and its decimation to 4,200 vertices, for
both of which that is above 3 edge lengths, the share of the strongest features that are found again is a tenth larger
than at 2.5 %.
*/
inline double default_ball_radius(const Rest_shape& shape)
{
  const double h = shape.mean_edge_length();
  return (std::min)((std::max)(0.045 * shape.diameter(), 3 * h), 8 * h);
}

/*!
\ingroup PkgAnimatedMeshFeaturesBalls

computes the geodesic ball of each vertex on the rest shape of an animation. Time and memory are those of the policy,
linear in `N` with the default.

\tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result is the same.
\tparam Animation a model of `MeshAnimation`.
\tparam GeodesicBalls a model of `GeodesicBalls`.
\param animation of which only the rest shape counts.
\param radius length on the rest shape; 0 stands for `default_ball_radius()`.
\param policy how balls are found.
\returns a row of vertex ranks for each vertex, ascending, itself included.
\throw Option_error if the radius is negative or not finite. What the policy throws.
*/
template <class ConcurrencyTag = CGAL::Sequential_tag, class Animation,
          class GeodesicBalls = Heat_method_geodesic_balls>
Compressed_rows geodesic_balls(const Animation& animation, double radius = 0,
                               const GeodesicBalls& policy = GeodesicBalls())
{
  const internal::Animation_access<Animation> access(animation);
  if (!(radius >= 0) || !std::isfinite(radius)) throw Option_error("the radius of the geodesic balls must be positive");
  const Rest_shape& shape = access->rest_shape();
  Default_visitor visitor;
  return policy(shape, radius > 0 ? radius : default_ball_radius(shape),
                internal::Task_loop<ConcurrencyTag, Default_visitor>(visitor, Stage::GEODESIC_BALLS));
}

/*!
\ingroup PkgAnimatedMeshFeaturesMeasures

computes the curvature at every vertex in every frame, over geodesic balls of the rest shape.

Linear in the number of entries of `balls` times frames.

\tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result is the same, bit for bit.
\tparam Animation a model of `MeshAnimation`.
\tparam CurvatureMeasure a model of `CurvatureMeasure`.
\param animation the animation.
\param balls a row for each vertex, ascending; see `geodesic_balls()`.
\param measure what is summed over a ball.
\returns a field of `N x F` curvatures, rows in the order of `vertices(mesh)`; 0 where a ball has no edge.
*/
template <class ConcurrencyTag = CGAL::Sequential_tag, class Animation, class CurvatureMeasure = Mean_curvature_density>
Spatio_temporal_field<typename Animation::FT> curvature(const Animation& animation,
                                                        const Compressed_rows& balls,
                                                        const CurvatureMeasure& measure = CurvatureMeasure())
{
  const internal::Animation_access<Animation> access(animation);
  Default_visitor visitor;
  return internal::curvature_rows(access->flat_animation(), balls, measure,
                                  internal::Task_loop<ConcurrencyTag, Default_visitor>(visitor, Stage::CURVATURE));
}

/*!
\ingroup PkgAnimatedMeshFeaturesMeasures

computes \f$|\kappa(v, f) - \kappa(v, \mathrm{rest})|\f$ at every vertex in every frame; see `curvature()`.

\tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result is the same, bit for bit.
\tparam Animation a model of `MeshAnimation`.
\tparam CurvatureMeasure a model of `CurvatureMeasure`.
\param animation the animation.
\param balls a row for each vertex, ascending; see `geodesic_balls()`.
\param measure what is summed over a ball.
\returns a field of `N x F` non-negative changes, without unit.
*/
template <class ConcurrencyTag = CGAL::Sequential_tag, class Animation, class CurvatureMeasure = Mean_curvature_density>
Spatio_temporal_field<typename Animation::FT> curvature_change(const Animation& animation,
                                                               const Compressed_rows& balls,
                                                               const CurvatureMeasure& measure = CurvatureMeasure())
{
  const internal::Animation_access<Animation> access(animation);
  Default_visitor visitor;
  return internal::curvature_change_rows(
      access->flat_animation(), balls, measure,
      internal::Task_loop<ConcurrencyTag, Default_visitor>(visitor, Stage::CURVATURE));
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_CURVATURE_H
