// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_FEATURE_REGIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_FEATURE_REGIONS_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
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

What the region of a feature is worth in a frame.
*/
enum class Region_course
{
  PRESENT, ///< 1 in the frames within \f$\tau\f$ of the feature's time, 0 in others
  GAUSSIAN ///< \f$e^{-(t-t_0)^2/2\tau^2}\f$, the course of the event in time; 0 beyond \f$3\,\tau\f$
};

namespace internal {

// What a region is worth in each frame from the first one on in which it is worth something.
struct Region_weights
{
  std::size_t first = 0;
  std::vector<float> values;

  Region_weights(const Feature_point& f, std::size_t frames, double frame_duration, Region_course course)
  {
    const double reach = course == Region_course::PRESENT ? 1 : 3;
    for (std::size_t m = 0; m < frames; ++m) {
      const double x = (double(m) * frame_duration - f.time) / f.tau;
      if (!(std::abs(x) <= reach)) continue;
      if (values.empty()) first = m;
      values.push_back(course == Region_course::PRESENT ? 1.f : float(std::exp(-x * x / 2)));
    }
  }
};

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

makes the map of feature regions: for each vertex and frame the most that a feature's region is worth there. The region of
a feature is the disc of radius \f$\sigma\f$ about its vertex on the rest shape, by paths along edges (V. Mykhalchuk,
H. Seo, F. Cordier, On spatio-temporal feature point detection for animated meshes, 2014, sect. 6.2).

\param shape the surface at rest, `N` vertices.
\param frames the number of frames, `F`.
\param frame_duration the time between two frames (s), positive.
\param features a range of `Feature_point`; of them the vertex, the time, \f$\sigma\f$ and \f$\tau\f$ are used.
\param course how a region comes and goes.
\returns `N x F`, from 0 to 1.
\throw Input_error if a vertex is not of the shape, or \f$\sigma\f$ or \f$\tau\f$ is not positive.

For a feature with `k` vertices in its region in `m` frames, \f$O(k (\log k + m))\f$.
*/
template <class FeatureRange>
Spatio_temporal_field<float> feature_regions(const Rest_shape& shape, std::size_t frames, double frame_duration,
                                             const FeatureRange& features, Region_course course)
{
  if (!(frame_duration > 0)) throw Option_error("the time between two frames must be positive");
  Spatio_temporal_field<float> regions(shape.number_of_vertices(), frames);
  internal::Bounded_dijkstra paths(shape);
  for (const Feature_point& f : features) {
    internal::cancellation_point();
    if (f.vertex_index >= shape.number_of_vertices() || !(f.sigma > 0) || !(f.tau > 0))
      throw Input_error("the feature at vertex " + std::to_string(f.vertex_index) + " has sigma " +
                        std::to_string(f.sigma) + " and tau " + std::to_string(f.tau) + ", the rest shape " +
                        std::to_string(shape.number_of_vertices()) + " vertices: it has no region");
    const internal::Region_weights weights(f, frames, frame_duration, course);
    const std::array<Rest_shape::Index, 1> centre = {{Rest_shape::Index(f.vertex_index)}};
    for (Rest_shape::Index v : paths.run(centre, f.sigma)) {
      float* const row = regions.row(v) + weights.first;
      for (std::size_t m = 0; m < weights.values.size(); ++m) row[m] = (std::max)(row[m], weights.values[m]);
    }
  }
  return regions;
}

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

sums a map over all frames: of feature regions that are `Region_course::PRESENT`, in how many frames each vertex is in one.

\returns `N x 1`.
*/
inline Spatio_temporal_field<float> summed_over_frames(const Spatio_temporal_field<float>& map)
{
  Spatio_temporal_field<float> sums(map.number_of_rows(), 1);
  for (std::size_t v = 0; v < map.number_of_rows(); ++v) {
    double sum = 0;
    for (std::size_t m = 0; m < map.number_of_frames(); ++m) sum += double(map(v, m));
    sums(v, 0) = float(sum);
  }
  return sums;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_FEATURE_REGIONS_H
