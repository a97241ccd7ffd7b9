// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_MATCHING_ERRORS_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_MATCHING_ERRORS_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

A feature where it is on the rest shape on which errors are measured: its own, or that of another animation, to which its
vertex was mapped.
*/
struct Feature_on_shape
{
  Rest_shape::Index vertex = 0; ///< of the shape
  double time = 0;              ///< seconds
};

namespace internal {

inline void check_vertices(const std::vector<Feature_on_shape>& features, const Rest_shape& shape)
{
  for (const Feature_on_shape& f : features)
    if (f.vertex >= shape.number_of_vertices())
      throw Input_error("a feature is at vertex " + std::to_string(f.vertex) + ", the rest shape has " +
                        std::to_string(shape.number_of_vertices()) + " vertices");
}

// From the vertex to the nearest of the partners; infinity if there is none on its component.
inline double distance_to_nearest(const Rest_shape& shape, Rest_shape::Index vertex,
                                  const std::vector<Rest_shape::Index>& partners, Bounded_dijkstra& paths)
{
  const double infinity = Bounded_dijkstra::infinity;
  double nearest = infinity;
  // Each run reaches some four times as many vertices as the one before: the last one is most of the work.
  double limit = 4 * shape.mean_edge_length();
  for (bool is_last = partners.empty(); !is_last && nearest == infinity; limit *= 2) {
    is_last = !(limit < 4 * shape.bounding_box_diagonal());
    paths.run(std::array<Rest_shape::Index, 1>{{vertex}}, is_last ? infinity : limit);
    for (Rest_shape::Index v : partners) nearest = (std::min)(nearest, paths.distance(v));
  }
  return nearest;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

measures how far each feature is from the nearest of others, whatever their times: the matching error of V. Mykhalchuk,
H. Seo, F. Cordier, On spatio-temporal feature point detection for animated meshes, 2014, sect. 6.1.

Distances are lengths of shortest paths along edges of the rest shape, some 10 % too long on irregular meshes and never too
short. All of them in \f$O(N \log N)\f$.

\param shape the surface at rest.
\param features of which the errors are asked.
\param others among which the nearest is looked for.
\returns for each feature the distance (length); infinity if no other one is on its component.
\throw Input_error if a vertex is not of the shape.
*/
inline std::vector<double> matching_errors(const Rest_shape& shape, const std::vector<Feature_on_shape>& features,
                                           const std::vector<Feature_on_shape>& others)
{
  internal::check_vertices(features, shape);
  internal::check_vertices(others, shape);
  std::vector<Rest_shape::Index> sources;
  for (const Feature_on_shape& f : others) sources.push_back(f.vertex);
  internal::Bounded_dijkstra paths(shape);
  paths.run(sources, internal::Bounded_dijkstra::infinity);
  std::vector<double> errors;
  for (const Feature_on_shape& f : features) errors.push_back(paths.distance(f.vertex));
  return errors;
}

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

the same among those others only that are at the same time.

For each feature paths are followed outwards until one of them is reached, so that a feature near its partner costs little;
one that has none costs \f$O(N \log N)\f$.

\tparam ConcurrencyTag on how many threads; the result is the same.
\param shape, features, others as above.
\param time the largest distance in time (s).
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag>
std::vector<double> matching_errors(const Rest_shape& shape, const std::vector<Feature_on_shape>& features,
                                    const std::vector<Feature_on_shape>& others, double time)
{
  internal::check_vertices(features, shape);
  internal::check_vertices(others, shape);
  std::vector<double> errors(features.size());
  internal::Thread_local<internal::Bounded_dijkstra> workspaces;
  parallel_for<ConcurrencyTag>(0, features.size(), [&](std::size_t i) {
    internal::Bounded_dijkstra& paths =
        workspaces.get([&] { return std::make_unique<internal::Bounded_dijkstra>(shape); });
    std::vector<Rest_shape::Index> partners;
    for (const Feature_on_shape& o : others)
      if (std::abs(o.time - features[i].time) <= time) partners.push_back(o.vertex);
    errors[i] = internal::distance_to_nearest(shape, features[i].vertex, partners, paths);
  });
  return errors;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_MATCHING_ERRORS_H
