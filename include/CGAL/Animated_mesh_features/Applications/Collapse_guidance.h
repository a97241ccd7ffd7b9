// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_COLLAPSE_GUIDANCE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_COLLAPSE_GUIDANCE_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

Every place matters as much as any other, at all times: the default.

\cgalModels{CollapseGuidance}
*/
struct Plain_guidance
{
  /// 1
  double operator()(std::size_t, std::size_t) const { return 1; }
};

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

Places matter more where and while features are: in a frame at time \f$t\f$, at the distance \f$d\f$ along edges from
a feature of the amplitude \f$a\f$ (relative to the largest), by
\f$1 + s\,a\,e^{-d^2/2\sigma^2 - (t-t_0)^2/2\tau^2}\f$, of all features the most.

\cgalModels{CollapseGuidance}
*/
class Feature_guidance
{
public:
  /*!
  computes the weights, in `O(k (log k + m))` for a feature with `k` vertices within \f$3\,\sigma\f$ in `m` frames,
  and `4 N F` bytes.

  \param rest the surface at rest, `N` vertices.
  \param frames the number of frames, `F`.
  \param frame_duration the time between two frames (s), positive.
  \param features a range of `Feature_point`.
  \param strength \f$s\f$, not negative; 0 is plain.
  \throw Option_error if the strength or the duration makes no sense.
  \throw Input_error if a feature's vertex is not of the shape, or \f$\sigma\f$ or \f$\tau\f$ is not positive.
  */
  template <class FeatureRange>
  Feature_guidance(const Rest_shape& rest, std::size_t frames, double frame_duration, const FeatureRange& features,
                   double strength)
    : m_strength(strength)
    , m_regions(rest.number_of_vertices(), frames)
  {
    if (!(strength >= 0) || !std::isfinite(strength))
      throw Option_error("the strength of guidance must not be negative");
    if (!(frame_duration > 0)) throw Option_error("the time between two frames must be positive");
    double largest = 0;
    for (const Feature_point& f : features) largest = (std::max)(largest, f.amplitude);
    internal::Bounded_dijkstra paths(rest);
    for (const Feature_point& f : features) {
      if (f.vertex_index >= rest.number_of_vertices() || !(f.sigma > 0) || !(f.tau > 0))
        throw Input_error("the feature at vertex " + std::to_string(f.vertex_index) + " has sigma " +
                          std::to_string(f.sigma) + " and tau " + std::to_string(f.tau) + ", the rest shape " +
                          std::to_string(rest.number_of_vertices()) + " vertices: it has no region");
      const double amplitude = largest > 0 ? (std::max)(0., f.amplitude) / largest : 1;
      const std::array<Rest_shape::Index, 1> centre = {{Rest_shape::Index(f.vertex_index)}};
      for (Rest_shape::Index v : paths.run(centre, 3 * f.sigma)) {
        const double d = paths.distance(v) / f.sigma;
        for (std::size_t m = 0; m < frames; ++m) {
          const double t = (double(m) * frame_duration - f.time) / f.tau;
          if (!(std::abs(t) <= 3)) continue;
          m_regions(v, m) = (std::max)(m_regions(v, m), float(amplitude * std::exp(-(d * d + t * t) / 2)));
        }
      }
    }
  }

  /// how much the surface at a vertex matters in a frame.
  double operator()(std::size_t vertex, std::size_t frame) const
  {
    return 1 + m_strength * double(m_regions(vertex, frame));
  }

private:
  double m_strength;
  Spatio_temporal_field<float> m_regions;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_COLLAPSE_GUIDANCE_H
