// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_GLOBAL_HEAT_METHOD_GEODESIC_BALLS_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_GLOBAL_HEAT_METHOD_GEODESIC_BALLS_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/CGAL_heat_patch.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesBalls

Geodesic balls by \cgal's class for the heat method on the whole mesh; a model of `GeodesicBalls`, for comparison.

The matrices are factored once and solved for each vertex, so that the time grows with the square of the number of
vertices: 2.3 ms a vertex at 8,000 vertices, 63 ms at 100,000.

\cgalModels{GeodesicBalls}
*/
struct Global_heat_method_geodesic_balls
{
  /*!
  collects the balls of all vertices.

  \returns for each vertex the vertices within `radius` of it, itself included, ascending.
  \param shape the rest shape.
  \param radius positive; length.
  \param loop runs tasks, see `GeodesicBalls`.
  \throw Numerical_error if the heat method's matrices cannot be factored.
  */
  template <class Loop>
  Compressed_rows operator()(const Rest_shape& shape, double radius, const Loop& loop) const
  {
    struct Workspace
    {
      explicit Workspace(const Rest_shape& shape)
        : dijkstra(shape)
        , patch(shape, shape.ordered_triangles())
      {
      }
      internal::Bounded_dijkstra dijkstra;
      internal::CGAL_heat_patch patch;
    };
    std::vector<std::vector<Rest_shape::Index>> balls(shape.number_of_vertices());
    internal::Thread_local<Workspace> workspaces;
    loop(balls.size(), [&](std::size_t v) {
      Workspace& w = workspaces.get([&] { return std::make_unique<Workspace>(shape); });
      balls[v] = internal::clamped_heat_ball(shape, w.dijkstra, w.patch, Rest_shape::Index(v), radius);
    });
    return Compressed_rows(std::move(balls));
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_GLOBAL_HEAT_METHOD_GEODESIC_BALLS_H
