// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_DETECTOR_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_DETECTOR_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/check_field.h>
#include <CGAL/Animated_mesh_features/Animation/check_timing.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_selection.h>
#include <CGAL/Animated_mesh_features/Detection/Spatio_temporal_feature.h>
#include <CGAL/Animated_mesh_features/Detection/internal/Fitted_minima.h>
#include <CGAL/Animated_mesh_features/Detection/internal/Time_difference.h>
#include <CGAL/Animated_mesh_features/Detection/internal/selected_features.h>
#include <CGAL/Animated_mesh_features/Extrema/Extremum_options.h>
#include <CGAL/Animated_mesh_features/Extrema/find_response_extrema.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage_scope.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>
#include <CGAL/Animated_mesh_features/Scale_space/is_periodic.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

The second stage of a detection: a field over a rest shape in, features out. The field is the deformation of a
`Deformation_measurement`, or one of your own: temperature, muscle activity, error of a simulation; its positive bumps are
found.

All minima of the response are kept, with their refined places and their fits once they were asked for: asking again with
another selection costs next to nothing.

The strength of a feature is its amplitude times its fit (see `Feature_point`), with a response that knows of no amplitude
`-response`; where the ranges of scales begin it is less, see `Scale_fade`. If the options bring no selection, it is `Feature_selection::of_any_field()`.

A feature's `vertex` is the same as its `vertex_index`, and its `position` is that on the rest shape; `place_on_animation()`
puts it on a moving mesh.

With a temporal filter that joins the ends of a row (`Boundary_condition::PERIODIC`), the animation is cyclic: its period is F
frames, a feature may be in any of them and lie across the end, and all differences in time are taken the shorter way round.
What is found is what would be found in each period if the frames were repeated for ever.

\tparam FT `float` or `double`, the scalar of the field.
\tparam Options an `Extremum_options`; a `Detection_options` is one.
\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` or `CGAL::Sequential_tag`. Results are the same, bit for bit.
*/
template <class FT, class Options = Extremum_options<>, class ConcurrencyTag = CGAL::Parallel_if_available_tag>
class Feature_detector
{
public:
  typedef Spatio_temporal_field<FT> Field;                   ///< of deformations, for instance
  typedef Spatio_temporal_feature<Rest_shape::Index> Feature; ///< what is found

  /*!
  takes over a field.

  \param shape the surface at rest; is kept by reference.
  \param field `N x F`, rows in the order of the shape's vertices. Where it is not needed any more, move it.
  \param frame_duration the time between two frames (s).
  \param options a policy for each step; a `Detection_options` brings its `selection`, too.
  \param noise responses that are at most that strong count as errors of the field; of a deformation, see
    `Deformation_measurement::noise()`.
  \throw Option_error if the field has another number of rows than the shape has vertices, or the noise is negative.
  \throw Input_error if a value of the field is not finite, there are fewer than 3 frames, or the time between them is not
    positive.
  */
  Feature_detector(const Rest_shape& shape, Field field, double frame_duration, Options options = Options(),
                   double noise = 0)
    : m_shape(&shape)
    , m_field(std::move(field))
    , m_frame_duration(frame_duration)
    , m_options(std::move(options))
    , m_selection(internal::selection_of(m_options, 0))
    , m_noise(noise)
  {
    if (!(noise >= 0)) throw Option_error("the noise of a field must not be negative");
    internal::check_timing(m_field.number_of_frames(), frame_duration);
    internal::check_field(m_field, shape.number_of_vertices());
  }

  /// the field in which features are found.
  const Field& field() const { return m_field; }

  /// what the detector was told.
  const Options& options() const { return m_options; }

  /// which minima become features; may be changed at any time.
  Feature_selection& selection() { return m_selection; }
  const Feature_selection& selection() const { return m_selection; } ///< the same, to look at

  /*!
  writes the features to `out`, strongest first.

  Time and memory: those of `find_response_extrema()` at the first call; for each minimum that is strong enough and was not
  asked for before, a look at the samples of the field around it, see `Feature_fit_measure`; then linear in their number.

  \param out an output iterator of `Feature`.
  \param visitor a model of `DetectionVisitor`, by default one that does nothing.
  \throw Option_error if a threshold is out of its range, or the sampling finds no levels. Nothing is written if an
    exception is thrown.
  \throw Numerical_error if a matrix cannot be factored.
  \throw Cancelled if the visitor asks for it.
  */
  template <class OutputIterator>
  OutputIterator operator()(OutputIterator out, Any_visitor visitor = Any_visitor())
  {
    m_selection.check();
    if (!m_minima) find_minima(visitor);
    // those that have no fit yet are measured in a stage of their own
    const auto measure = [&](std::size_t tasks, const auto& task) {
      const internal::Stage_scope stage(visitor, Stage::EXTREMA);
      // a range of no length: the search before has told all of the progress
      Task_loop<ConcurrencyTag, Any_visitor>(visitor, Stage::EXTREMA, 1, 1)(tasks, task);
    };
    const bool is_cyclic = is_periodic(m_options.temporal_filter);
    const internal::Time_difference between(is_cyclic ? double(m_field.number_of_frames()) * m_frame_duration : 0);
    const std::vector<Feature> selected = internal::selected_features(
        *m_shape, m_minima->above(m_selection, *m_shape, m_field, m_frame_duration, is_cyclic, measure), m_selection,
        between);
    return std::copy(selected.begin(), selected.end(), out);
  }

  /// the number of minima of the response, before thresholds and suppression, but above the noise and the rounding errors
  /// of the smoothing, so that a body that moves rigidly has none; 0 before the first detection.
  std::size_t number_of_minima() const { return m_minima ? m_minima->size() : 0; }

  /// \name Levels of the last detection
  /// @{
  const std::vector<double>& sigma_levels() const { return m_sigma; } ///< the \f$\sigma\f$ of all space levels (length)
  const std::vector<double>& tau_levels() const { return m_tau; }     ///< the \f$\tau\f$ of all time levels (seconds)
  /// @}

private:
  void find_minima(Any_visitor visitor)
  {
    Response_extrema found =
        find_response_extrema<ConcurrencyTag>(*m_shape, m_field, m_frame_duration, m_options, m_noise, visitor);
    std::vector<Feature> minima;
    minima.reserve(found.extrema.size());
    for (const Response_extremum& e : found.extrema) minima.push_back(feature(e));
    m_minima =
        internal::Fitted_minima<Feature>(std::move(minima), found.has_amplitudes, found.sigma_fade, found.tau_fade);
    m_sigma = std::move(found.sigma_levels);
    m_tau = std::move(found.tau_levels);
  }

  Feature feature(const Response_extremum& e) const
  {
    Feature result;
    result.vertex = Rest_shape::Index(e.vertex);
    result.vertex_index = e.vertex;
    result.frame = e.frame;
    result.refined_frame = e.refined_frame;
    result.time = e.refined_frame * m_frame_duration;
    result.triangle = e.triangle;
    result.barycentric_coordinates = e.barycentric_coordinates;
    result.sigma = e.sigma;
    result.tau = e.tau;
    result.response = e.response;
    result.amplitude = e.amplitude;
    result.at_scale_limit = e.at_scale_limit;
    Rest_shape::Point rest = Rest_shape::Point::Zero();
    for (std::size_t i = 0; i < 3; ++i) rest += e.barycentric_coordinates[i] * m_shape->points()[e.triangle[i]];
    for (std::size_t i = 0; i < 3; ++i) result.rest_position[i] = rest[Eigen::Index(i)];
    result.position = result.rest_position;
    return result;
  }

  const Rest_shape* m_shape;
  Field m_field;
  double m_frame_duration;
  Options m_options;
  Feature_selection m_selection;
  double m_noise;
  std::optional<internal::Fitted_minima<Feature>> m_minima;
  std::vector<double> m_sigma, m_tau;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_DETECTOR_H
