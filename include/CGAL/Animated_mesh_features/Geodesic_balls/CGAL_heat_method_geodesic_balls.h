// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_CGAL_HEAT_METHOD_GEODESIC_BALLS_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_CGAL_HEAT_METHOD_GEODESIC_BALLS_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/CGAL_heat_patch.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesBalls

Geodesic balls by \cgal's class for the heat method on local patches; a model of `GeodesicBalls`, for comparison.

What `Heat_method_geodesic_balls` does with its own matrices, which is eight to nine times faster: each distance is
clamped to [Euclid, shortest path along edges], only one source is used at a time. With clusters of a single vertex it
is the plain use of the class on the surroundings of each vertex, another seven times slower. Linear in the number of
vertices.

\cgalModels{GeodesicBalls}
*/
struct CGAL_heat_method_geodesic_balls
{
  /// vertices in a cluster. More share a factorisation, but solve on a larger patch.
  std::size_t cluster_size = 64;

  /// how far a patch reaches beyond the balls of its cluster, in mean edge lengths. The heat, which decays over one
  /// edge length, is 5 % there of what it is at the balls' rim, and the distances are fitted to its directions without
  /// any condition at the patch's rim.
  double patch_margin = 3;

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
    const Compressed_rows all = clusters(shape, radius);
    std::vector<std::vector<Rest_shape::Index>> balls(shape.number_of_vertices());
    internal::Thread_local<internal::Bounded_dijkstra> workspaces;
    loop(all.size(), [&](std::size_t c) {
      internal::Bounded_dijkstra& dijkstra =
          workspaces.get([&] { return std::make_unique<internal::Bounded_dijkstra>(shape); });
      std::vector<Rest_shape::Index> triangles;
      for (Rest_shape::Index v : dijkstra.run(all[c], radius + patch_margin * shape.mean_edge_length()))
        triangles.insert(triangles.end(), shape.incident_triangles()[v].begin(), shape.incident_triangles()[v].end());
      // by their vertices, as the order shows in the patch's sums
      std::sort(triangles.begin(), triangles.end(), [&](Rest_shape::Index s, Rest_shape::Index t) {
        return std::tie(shape.triangles()[s], s) < std::tie(shape.triangles()[t], t);
      });
      triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
      internal::CGAL_heat_patch patch(shape, triangles);
      for (Rest_shape::Index v : all[c])
        balls[v] = internal::clamped_heat_ball(shape, dijkstra, patch, v, radius);
    });
    return Compressed_rows(std::move(balls));
  }

private:
  // Each vertex without a cluster starts one, of the nearest vertices without a cluster.
  Compressed_rows clusters(const Rest_shape& shape, double radius) const
  {
    Compressed_rows result;
    std::vector<char> taken(shape.number_of_vertices(), 0);
    std::vector<Rest_shape::Index> cluster;
    internal::Bounded_dijkstra dijkstra(shape);
    for (std::size_t v = 0; v < taken.size(); ++v) {
      if (taken[v]) continue;
      cluster.clear();
      for (Rest_shape::Index w : dijkstra.run(std::array<Rest_shape::Index, 1>{{Rest_shape::Index(v)}}, radius))
        if (!taken[w] && cluster.size() < cluster_size) {
          taken[w] = 1;
          cluster.push_back(w);
        }
      result.push_back(cluster.begin(), cluster.end());
    }
    return result;
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_CGAL_HEAT_METHOD_GEODESIC_BALLS_H
