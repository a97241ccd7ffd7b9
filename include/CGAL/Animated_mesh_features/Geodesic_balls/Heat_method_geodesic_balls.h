// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_HEAT_METHOD_GEODESIC_BALLS_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_HEAT_METHOD_GEODESIC_BALLS_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Cluster_ball_finder.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Cluster_balls.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Vertex_clusters.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesBalls

Geodesic balls by the heat method of Crane, Weischedel and Wardetzky \cgalCite{crane2013} on local patches; a model of
`GeodesicBalls`, the default.

Vertices are grouped in clusters of neighbours. The two matrices of the method are factored once on the patch that
reaches one radius and `patch_margin` mean edge lengths beyond a cluster, and solved for the vertices of the cluster,
eight at a time in vector registers. Each distance is clamped to [Euclid, shortest path along edges]. Only one source is
used at a time, as distances to several are wrong next to the border. Degenerate triangles conduct no heat. Only what
edges lead to within twice the radius can be in a ball: no other component, and no other sheet.

Linear in the number of vertices: 17 us a vertex with 70 vertices in a ball, 25 us with 170 (shortest paths along edges
alone: 7 and 22). In memory, the balls take 4 bytes an entry and 8 bytes a vertex, plus at most 1 byte an entry before
they are complete, and 12 bytes a vertex for each thread.

Against exact geodesics, balls of three edge lengths have 98 to 99 % of their edges in common on smooth meshes, with
borders and with slivers, and 94 % on a scanned horse, where vertices wrongly in or out are 3 % of the radius off the
rim in the mean; against \cgal's heat method on the whole mesh, 97 to 99 %. (Shortest paths along edges: 80 to 85 %.)

The clusters do not depend on the numbering of the vertices, except for ties. On a shape with symmetries, which has
them, renumbering changes distances at the rim of a ball by some 10^-3 of the radius, and strengths of features in the
third digit.

\cgalModels{GeodesicBalls}
*/
struct Heat_method_geodesic_balls
{
  /// radius of the clusters, as a multiple of what a patch reaches beyond its cluster. The greater, the more vertices
  /// share a factorisation, the larger the patch on which each is solved, and the fewer tasks there are for threads. The
  /// time is the same within a twentieth from 0.9 to 1.3.
  double cluster_radius = 0.9;

  /// how far a patch reaches beyond the balls of its cluster, in mean edge lengths: the distances are fitted to the
  /// directions of the heat without any condition at the patch's rim, so that it may be near. With 0.5 to 5, as many
  /// edges are in common with exact balls, but with 1, 1 % fewer with those of the whole mesh than with 3.
  double patch_margin = 2;

  /*!
  collects the balls of all vertices.

  \returns for each vertex the vertices within `radius` of it, itself included, ascending.
  \param shape the rest shape.
  \param radius positive; length.
  \param loop runs tasks, see `GeodesicBalls`.
  */
  template <class Loop>
  Compressed_rows operator()(const Rest_shape& shape, double radius, const Loop& loop) const;
};

// Outside of the class: a function that is defined within it is compiled wherever it is used, also where it is had
// compiled.
template <class Loop>
Compressed_rows Heat_method_geodesic_balls::operator()(const Rest_shape& shape, double radius, const Loop& loop) const
{
  const double margin = patch_margin * shape.mean_edge_length();
  const double reach = cluster_radius * (radius + margin);
  const Compressed_rows clusters = internal::Vertex_clusters(shape, reach).rows();
  std::vector<internal::Cluster_balls> balls(clusters.size());
  internal::Thread_local<internal::Cluster_ball_finder> finders;
  loop(clusters.size(), [&](std::size_t c) {
    internal::Cluster_ball_finder& find =
        finders.get([&] { return std::make_unique<internal::Cluster_ball_finder>(shape, radius, margin, 2 * reach); });
    balls[c] = find(clusters[c]);
  });
  return internal::Cluster_balls::rows(balls, shape.number_of_vertices());
}

} // namespace Animated_mesh_features
} // namespace CGAL

#ifdef CGAL_ANIMATED_MESH_FEATURES_COMPILED
  #include <CGAL/Animated_mesh_features/Geodesic_balls/internal/instances.inl>
#endif

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_HEAT_METHOD_GEODESIC_BALLS_H
