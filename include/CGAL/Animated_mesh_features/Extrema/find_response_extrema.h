// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_FIND_RESPONSE_EXTREMA_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_FIND_RESPONSE_EXTREMA_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/check_field.h>
#include <CGAL/Animated_mesh_features/Extrema/Extremum_options.h>
#include <CGAL/Animated_mesh_features/Extrema/Response_extremum.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Extremum.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Scale_space_engine.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Time_axis.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/refine_extremum.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage_scope.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>
#include <CGAL/Animated_mesh_features/Scale_space/Scale_levels.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// A minimum has a level on either side, and all three have those of which their differences are made.
template <class Response>
void check_number_of_levels(const Scale_levels& levels)
{
  constexpr std::size_t least = Response::below + Response::above + 3;
  if (levels.space_variances.size() < least || levels.time_variances.size() < least)
    throw Option_error("there are " + std::to_string(levels.space_variances.size()) + " space levels and " +
                       std::to_string(levels.time_variances.size()) + " time levels; at least " +
                       std::to_string(least) + " of each are needed");
}

// An extremum on the grid of samples, refined.
template <class Options>
Response_extremum refined(const Extremum& e, const Rest_shape& shape, const Time_axis& time, const Scale_levels& levels,
                          const Options& options, const Response_extrema& result)
{
  typedef typename Options::SpaceTimeResponse Response;
  const Refined_scales scales = refine_scales(e);
  const auto sigma = [&](std::size_t k) {
    return levels.sigma_factor * std::sqrt(options.spatial_filter.variance(k, e.vertex));
  };
  const std::vector<double>& tau = result.tau_levels;
  const auto is_outermost = [](std::size_t i, std::size_t size) {
    return i == Response::below + 1 || i + Response::above + 2 == size;
  };
  const Refined_place place = refine_place(shape, e);
  Response_extremum r;
  r.vertex = e.vertex;
  r.frame = e.frame;
  r.refined_frame = time.wrapped(double(e.frame) + scales.frame);
  r.triangle = place.triangle;
  r.barycentric_coordinates = place.barycentric;
  r.sigma = interpolated_scale(sigma(e.k - 1), sigma(e.k), sigma(e.k + 1), scales.space_level);
  r.tau = interpolated_scale(tau[e.l - 1], tau[e.l], tau[e.l + 1], scales.time_level);
  r.response = scales.response;
  r.at_scale_limit = is_outermost(e.k, result.sigma_levels.size()) || is_outermost(e.l, result.tau_levels.size());
  return r;
}

// Whether a response knows the amplitude of an event.
template <class Response, class = void>
struct Has_amplitude : std::false_type
{
};
template <class Response>
struct Has_amplitude<Response, std::enable_if_t<Response::has_amplitude>> : std::true_type
{
};

// The dimension d of the surface around a vertex at a space level: the factors are proportional to sigma^((d - 2) / 2).
inline double dimension(const Extremum& e, const std::vector<float>& factors, const std::vector<double>& sigma)
{
  if (factors.empty()) return 2;
  const float* const factor = factors.data() + e.vertex * sigma.size();
  const double slope = std::log(double(factor[e.k + 1]) / double(factor[e.k - 1])) / std::log(sigma[e.k + 1] / sigma[e.k - 1]);
  return (std::min)(2., (std::max)(0., 2 + 2 * slope));
}

template <class Response>
double amplitude(const Extremum& e, const Response_extremum& refined, const Response& response,
                 const std::vector<float>& factors, const std::vector<double>& sigma)
{
  if constexpr (Has_amplitude<Response>::value) {
    const double factor = factors.empty() ? 1 : double(factors[e.vertex * sigma.size() + e.k]);
    return response.amplitude(refined.response / factor, e.k, e.l, refined.sigma, refined.tau,
                              dimension(e, factors, sigma));
  } else
    return -refined.response;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesExtrema

finds the extrema of the response over the scale space of a field: a field and a rest shape in, refined extrema out. The
field may be a deformation or anything else that lives on a surface in time; features are made of these extrema by
`Feature_detector`.

With a temporal filter that joins the ends of a row (see `is_periodic()`), extrema may be in any frame, else not in the first
nor in the last, which have a neighbour in time on one side only.

Time: linear in `N F` times the number of space levels times the number of time levels, plus the spatial filter. Memory:
see `Extremum_options::level_memory`; levels live where the field does.

\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` or `CGAL::Sequential_tag`. The result is the same, bit for bit.
\tparam FT `float` or `double`; the smoothing is in double precision.
\tparam SpatialFilter, TemporalFilter, ScaleSampling, SpaceTimeResponse, ExtremumSearch, ScaleNormalization see
`Extremum_options`.

\param shape the surface at rest.
\param field `N x F`, rows in the order of the shape's vertices.
\param frame_duration the time between two frames (s).
\param options a policy for each step.
\param noise responses that are at most that strong count as errors of the field.
\param visitor is told of the progress and may cancel; a model of `DetectionVisitor`, by default one that does nothing.

\throw Option_error if the field has another shape, the sampling finds too few levels, or what the policies throw.
\throw Input_error if a value of the field is not finite.
\throw Numerical_error if a matrix cannot be factored.
\throw Cancelled if the visitor asks for it.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class FT, class SpatialFilter, class TemporalFilter,
          class ScaleSampling, class SpaceTimeResponse, class ExtremumSearch, class ScaleNormalization>
Response_extrema find_response_extrema(
    const Rest_shape& shape, const Spatio_temporal_field<FT>& field, double frame_duration,
    Extremum_options<SpatialFilter, TemporalFilter, ScaleSampling, SpaceTimeResponse, ExtremumSearch, ScaleNormalization> options,
    double noise = 0, Any_visitor visitor = Any_visitor())
{
  typedef SpaceTimeResponse Response;
  internal::check_field(field, shape.number_of_vertices());
  const std::size_t frames = field.number_of_frames();
  const Scale_levels levels =
      options.sampling(shape, frames, frame_duration, options.spatial_filter, options.temporal_filter);
  internal::check_number_of_levels<Response>(levels);
  std::vector<float> factors;
  {
    const internal::Stage_scope stage(visitor, Stage::SCALE_SPACE);
    // a range of no length, so that the fraction is 0 until there are levels
    const Task_loop<ConcurrencyTag, Any_visitor> preparation(visitor, Stage::SCALE_SPACE, 0, 0);
    // as a task, so that it can be cancelled in the middle
    preparation(1, [&](std::size_t) {
      options.spatial_filter.initialize(shape, levels.space_variances, preparation);
      options.temporal_filter.initialize(frames, frame_duration, levels.time_variances);
      factors = options.normalization(shape, levels.space_variances, preparation);
    });
  }
  Response_extrema result;
  result.has_amplitudes = internal::Has_amplitude<Response>::value;
  result.sigma_fade = levels.sigma_fade;
  result.tau_fade = levels.tau_fade;
  for (std::size_t k = 0; k < levels.space_variances.size(); ++k)
    result.sigma_levels.push_back(levels.sigma_factor * std::sqrt(options.spatial_filter.variance(k)));
  for (std::size_t l = 0; l < levels.time_variances.size(); ++l)
    result.tau_levels.push_back(levels.tau_factor * std::sqrt(options.temporal_filter.variance(l)));
  options.response.initialize(result.sigma_levels, result.tau_levels, levels);

  internal::Scale_space_engine<TemporalFilter, Response, ExtremumSearch> engine(
      shape, frames, result.sigma_levels.size(), result.tau_levels.size(), options.temporal_filter, options.response,
      options.search);
  const std::size_t level_size = Spatio_temporal_field<double>::size_in_bytes(shape.number_of_vertices(), frames);
  constexpr std::size_t around = Response::below + Response::above + 2;
  const std::size_t levels_in_memory = options.level_memory / level_size;
  engine.set_largest_batch(levels_in_memory > around ? levels_in_memory - around : 1);
  engine.set_least_response(noise);
  engine.set_factors(factors);
  engine.set_frame_duration(frame_duration);
  const internal::Time_axis time(frames, options.temporal_filter);
  for (const internal::Extremum& e : engine.template run<ConcurrencyTag>(field, options.spatial_filter, visitor)) {
    if (!(-e.response() > noise)) continue;
    Response_extremum extremum = internal::refined(e, shape, time, levels, options, result);
    extremum.amplitude = internal::amplitude(e, extremum, options.response, factors, result.sigma_levels);
    if (levels.reported_sigma.contains(extremum.sigma) && levels.reported_tau.contains(extremum.tau))
      result.extrema.push_back(extremum);
  }
  return result;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#ifdef CGAL_ANIMATED_MESH_FEATURES_COMPILED
  #include <CGAL/Animated_mesh_features/Extrema/internal/instances.inl>
#endif

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_FIND_RESPONSE_EXTREMA_H
