// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_DIJKSTRA_GEODESIC_BALLS_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_DIJKSTRA_GEODESIC_BALLS_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesBalls

Geodesic balls by shortest paths along edges; a model of `GeodesicBalls`.

The quickest and most robust of the three, and the least accurate: paths along edges are too long by some 11 % on
irregular meshes, so that the balls are too small. `O(N k log k)` for `k` vertices in a ball.

\cgalModels{GeodesicBalls}
*/
struct Dijkstra_geodesic_balls
{
  /*!
  collects the balls of all vertices.

  \returns for each vertex the vertices within `radius` of it, itself included, ascending.
  \param shape the rest shape.
  \param radius positive; length.
  \param loop runs tasks, see `GeodesicBalls`.
  */
  template <class Loop>
  Compressed_rows operator()(const Rest_shape& shape, double radius, const Loop& loop) const
  {
    std::vector<std::vector<Rest_shape::Index>> balls(shape.number_of_vertices());
    internal::Thread_local<internal::Bounded_dijkstra> workspaces;
    loop(balls.size(), [&](std::size_t v) {
      internal::Bounded_dijkstra& dijkstra =
          workspaces.get([&] { return std::make_unique<internal::Bounded_dijkstra>(shape); });
      balls[v] = dijkstra.run(std::array<Rest_shape::Index, 1>{{Rest_shape::Index(v)}}, radius);
      std::sort(balls[v].begin(), balls[v].end());
    });
    return Compressed_rows(std::move(balls));
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_DIJKSTRA_GEODESIC_BALLS_H
