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
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

\param shape, features, others as above.
\param time the largest distance in time (s).
*/
inline std::vector<double> matching_errors(const Rest_shape& shape, const std::vector<Feature_on_shape>& features,
                                           const std::vector<Feature_on_shape>& others, double time)
{
  internal::check_vertices(features, shape);
  internal::check_vertices(others, shape);
  const double infinity = internal::Bounded_dijkstra::infinity;
  internal::Bounded_dijkstra paths(shape);
  std::vector<double> errors;
  for (const Feature_on_shape& f : features) {
    internal::cancellation_point();
    std::vector<Rest_shape::Index> partners;
    for (const Feature_on_shape& o : others)
      if (std::abs(o.time - f.time) <= time) partners.push_back(o.vertex);
    double nearest = infinity;
    // Each run reaches some four times as many vertices as the one before: the last one is most of the work.
    double limit = 4 * shape.mean_edge_length();
    for (bool is_last = partners.empty(); !is_last && nearest == infinity; limit *= 2) {
      is_last = !(limit < 4 * shape.bounding_box_diagonal());
      paths.run(std::array<Rest_shape::Index, 1>{{f.vertex}}, is_last ? infinity : limit);
      for (Rest_shape::Index v : partners) nearest = (std::min)(nearest, paths.distance(v));
    }
    errors.push_back(nearest);
  }
  return errors;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_MATCHING_ERRORS_H
