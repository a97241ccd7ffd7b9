// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_DESCRIBED_FEATURES_H
#define CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_DESCRIBED_FEATURES_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Descriptors/Surface_landmarks.h>
#include <CGAL/Animated_mesh_features/Descriptors/describe_features.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

Features of an animation with all that is compared with those of another one, whose mesh is another: what the field
around each of them is like, where on the body it is, and how far it is from the others. `M` features.
*/
struct Described_features
{
  std::vector<Feature_point> features; ///< `M`
  Feature_descriptors descriptors;     ///< of the field around them; of size `M`, or 0 if nothing is known of the field
  Feature_descriptors places; ///< profiles, see `Surface_landmarks`; of size `M`, or 0 if nothing is known of the mesh
  std::vector<float> distances; ///< `M x M` on the surface, in units of `unit`
  double unit = 1;              ///< a size of the body (length), in which \f$\sigma\f$ is compared, too
  double loop = 0;              ///< after which the animation begins again (s); 0 if it ends
};

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

puts together what is known of features of a mesh. Distances are those along edges, straight where there is no path.

`O(M N log N)` time, `O(M^2)` memory and `O(N)` for each thread.

\tparam Loop a model of `TaskLoop`.
\param shape the surface at rest.
\param landmarks on it.
\param features on it.
\param descriptors of the features, in the same order, or none.
\param loop runs the tasks, one for each feature.
\throw Input_error if a feature is at no vertex of the shape.
*/
template <class Loop>
Described_features described_features(const Rest_shape& shape, const Surface_landmarks& landmarks,
                                      std::vector<Feature_point> features, Feature_descriptors descriptors,
                                      const Loop& loop)
{
  for (const Feature_point& f : features)
    if (f.vertex_index >= shape.number_of_vertices())
      throw Input_error("a feature is at vertex " + std::to_string(f.vertex_index) + ", the rest shape has " +
                        std::to_string(shape.number_of_vertices()) + " vertices");
  Described_features result;
  result.unit = landmarks.mean_distance();
  const std::size_t m = features.size();
  result.places = Feature_descriptors(m, Surface_landmarks::profile_length);
  result.distances.resize(m * m);
  internal::Thread_local<internal::Bounded_dijkstra> workspaces;
  loop(m, [&](std::size_t i) {
    internal::Bounded_dijkstra& paths =
        workspaces.get([&] { return std::make_unique<internal::Bounded_dijkstra>(shape); });
    landmarks.profile(features[i].vertex_index, result.places[i]);
    const Rest_shape::Index from = Rest_shape::Index(features[i].vertex_index);
    paths.run(std::array<Rest_shape::Index, 1>{{from}}, (std::numeric_limits<double>::max)());
    for (std::size_t j = 0; j < m; ++j) {
      const Rest_shape::Index to = Rest_shape::Index(features[j].vertex_index);
      const double along = paths.distance(to);
      result.distances[i * m + j] =
          float((std::isfinite(along) ? along : (shape.points()[from] - shape.points()[to]).norm()) / result.unit);
    }
  });
  result.features = std::move(features);
  result.descriptors = std::move(descriptors);
  return result;
}

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

the same on all threads, without progress.
*/
inline Described_features described_features(const Rest_shape& shape, const Surface_landmarks& landmarks,
                                             std::vector<Feature_point> features,
                                             Feature_descriptors descriptors = Feature_descriptors())
{
  return described_features(
      shape, landmarks, std::move(features), std::move(descriptors),
      [](std::size_t n, const auto& task) { parallel_for<CGAL::Parallel_if_available_tag>(0, n, task); });
}

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

the same of features alone, as a file of features has them: without descriptors and places, with straight distances on
the rest shape.

\param features with their places at rest.
\param diagonal that of the bounding box of the rest shape (length), of which `unit` is 0.4: about as much as the mean
  distance on a body's surface.
\throw Input_error if the diagonal is not positive.
*/
inline Described_features described_features(std::vector<Feature_point> features, double diagonal)
{
  if (!(diagonal > 0)) throw Input_error("the diagonal of the rest shape must be positive");
  Described_features result;
  result.unit = 0.4 * diagonal;
  const std::size_t m = features.size();
  result.distances.resize(m * m);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      double squares = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double d = features[i].rest_position[k] - features[j].rest_position[k];
        squares += d * d;
      }
      result.distances[i * m + j] = float(std::sqrt(squares) / result.unit);
    }
  result.features = std::move(features);
  return result;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_DESCRIBED_FEATURES_H
