// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_ACTIVITY_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_ACTIVITY_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/check_timing.h>
#include <CGAL/Animated_mesh_features/Applications/Activity.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Activity_sums.h>
#include <CGAL/Animated_mesh_features/Descriptors/Surface_landmarks.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

measures the activity of an animation. Between frames the field is linear.

`O(N (T (L + P) + 128^2))` time for `T` samples, on all threads.

\tparam FT `float` or `double`, the scalar of the field.
\param field `N x F`, for instance the deformation.
\param areas of its `N` vertices, not negative: how much each counts.
\param eccentricities of the vertices, see `Surface_landmarks`; or none.
\param frame_duration the time between two frames (s).
\param options times.
\throw Input_error if there are fewer than 3 frames or samples, or too many of these; Option_error if an option is out
  of its range, or sizes do not fit.
*/
template <class FT>
Activity animation_activity(const Spatio_temporal_field<FT>& field, const std::vector<double>& areas,
                            const std::vector<double>& eccentricities, double frame_duration,
                            const Activity_options& options = Activity_options())
{
  options.check();
  internal::check_timing(field.number_of_frames(), frame_duration);
  if (areas.size() != field.number_of_rows() || (!eccentricities.empty() && eccentricities.size() != areas.size()))
    throw Option_error("the field has " + std::to_string(field.number_of_rows()) + " rows, there are " +
                       std::to_string(areas.size()) + " areas and " + std::to_string(eccentricities.size()) +
                       " eccentricities");
  const std::size_t steps = options.is_cyclic ? field.number_of_frames() : field.number_of_frames() - 1;
  const double frames = double(steps) * frame_duration / options.sample_duration;
  if (!(frames < double(options.max_samples)))
    throw Input_error("the animation lasts " + std::to_string(frames * options.sample_duration) + " s, more than " +
                      std::to_string(options.max_samples) + " samples of " + std::to_string(options.sample_duration) +
                      " s; a longer time between samples is needed");
  const std::size_t samples = std::size_t(std::lround(frames)) + (options.is_cyclic ? 0 : 1);
  internal::Activity_sums sums(samples, options, !eccentricities.empty());
  if (sums.samples() < 3)
    throw Input_error("the animation lasts " + std::to_string(frames * options.sample_duration) +
                      " s, less than 3 samples of " + std::to_string(options.sample_duration) +
                      " s; a shorter time between samples is needed");
  // The chunks depend on nothing but N, and their sums are added in their order.
  const std::size_t n = field.number_of_rows(), chunk = 512, chunks = (n + chunk - 1) / chunk;
  std::vector<internal::Activity_sums> parts(chunks, sums);
  parallel_for<CGAL::Parallel_if_available_tag>(0, chunks, [&](std::size_t c) {
    for (std::size_t v = c * chunk; v < (std::min)(n, (c + 1) * chunk); ++v)
      if (areas[v] > 0)
        parts[c].add(field.row(v), field.number_of_frames(), areas[v], eccentricities.empty() ? 0 : eccentricities[v]);
  });
  for (const internal::Activity_sums& part : parts) sums.add(part);
  return sums.activity();
}

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

measures the activity of an animation of which only the features are known: the field is taken for the sum of their
Gaussians, a row for each `Feature_point::place`, which counts by \f$\sigma^2\f$ of its strongest feature.

\param features with amplitudes.
\param frames, frame_duration of the animation.
\param options times.
\throw Input_error, Option_error as above.
*/
inline Activity activity_of_features(const std::vector<Feature_point>& features, std::size_t frames,
                                     double frame_duration, const Activity_options& options = Activity_options())
{
  std::size_t places = 0;
  for (const Feature_point& f : features) places = (std::max)(places, f.place + 1);
  places = (std::min)(places, features.size());
  const auto row_of = [&](const Feature_point& f) { return (std::min)(f.place, places - 1); };
  Spatio_temporal_field<double> field(places, frames);
  std::vector<double> areas(places, 0);
  for (const Feature_point& f : features) {
    if (!(f.sigma > 0) || !(f.tau > 0)) throw Input_error("sigma and tau of a feature must be positive");
    const std::size_t row = row_of(f);
    if (!(areas[row] > 0)) areas[row] = f.sigma * f.sigma;
    for (std::size_t k = 0; k < frames; ++k) {
      const double away = double(k) * frame_duration - f.time, period = double(frames) * frame_duration;
      const double t = (options.is_cyclic ? std::remainder(away, period) : away) / f.tau;
      field(row, k) += f.amplitude * std::exp(-t * t / 2);
    }
  }
  return animation_activity(field, areas, {}, frame_duration, options);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_ACTIVITY_H
