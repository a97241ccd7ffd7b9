// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_GEODESIC_BALLS_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_GEODESIC_BALLS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/default_ball_radius.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#include <CGAL/tags.h>

#include <cmath>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesBalls

finds the geodesic ball of each vertex of a shape. Time and memory are those of the policy, linear in `N` with the
default.

\tparam GeodesicBalls a model of `GeodesicBalls`.
\tparam TaskLoop a model of `TaskLoop`.
\param shape for instance `Frame_sequence::rest_shape()`.
\param radius length; 0 stands for `default_ball_radius()`.
\param policy how balls are found.
\param loop runs the policy's tasks.
\returns a row of vertex ranks for each vertex, ascending, itself included.
\throw Option_error if the radius is negative or not finite. What the policy throws.
*/
template <class GeodesicBalls, class TaskLoop>
Compressed_rows
geodesic_balls(const Rest_shape& shape, double radius, const GeodesicBalls& policy, const TaskLoop& loop)
{
  if (!(radius >= 0) || !std::isfinite(radius)) throw Option_error("the radius of the geodesic balls must be positive");
  return policy(shape, radius > 0 ? radius : default_ball_radius(shape), loop);
}

/*!
\ingroup PkgAnimatedMeshFeaturesBalls

the same without a visitor.

\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` or `CGAL::Sequential_tag`; the result is the same.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class GeodesicBalls = Heat_method_geodesic_balls>
Compressed_rows
geodesic_balls(const Rest_shape& shape, double radius = 0, const GeodesicBalls& policy = GeodesicBalls())
{
  Any_visitor visitor;
  return geodesic_balls(shape, radius, policy,
                        Task_loop<ConcurrencyTag, Any_visitor>(visitor, Stage::GEODESIC_BALLS));
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_GEODESIC_BALLS_H
