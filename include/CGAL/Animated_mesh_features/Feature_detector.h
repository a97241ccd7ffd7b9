// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_FEATURE_DETECTOR_H
#define CGAL_ANIMATED_MESH_FEATURES_FEATURE_DETECTOR_H

#include <CGAL/Animated_mesh_features/Detection_options.h>
#include <CGAL/Animated_mesh_features/Spatio_temporal_feature.h>
#include <CGAL/Animated_mesh_features/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Visitor.h>
#include <CGAL/Animated_mesh_features/curvature.h>
#include <CGAL/Animated_mesh_features/deformation.h>
#include <CGAL/Animated_mesh_features/exceptions.h>
#include <CGAL/Animated_mesh_features/internal/Animation_access.h>
#include <CGAL/Animated_mesh_features/internal/Scale_space_engine.h>
#include <CGAL/Animated_mesh_features/internal/check_field.h>
#include <CGAL/Animated_mesh_features/internal/noise_floor.h>
#include <CGAL/Animated_mesh_features/internal/place_feature.h>
#include <CGAL/Animated_mesh_features/internal/refine_extremum.h>
#include <CGAL/Animated_mesh_features/internal/selected_features.h>
#include <CGAL/Animated_mesh_features/strain.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

The detector for repeated use. What was asked for is kept, with what it needed: the geodesic balls, the fields, all minima
of the response with their refined places. (Strain and change of curvature only if they were asked for themselves.)
Asking again with another threshold costs next to nothing.

\tparam Animation a model of `MeshAnimation`. It is kept by reference.
\tparam Options a `Detection_options`.
\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` or `CGAL::Sequential_tag`. Results are the same, bit for bit.
*/
template <class Animation, class Options = Calibrated_options, class ConcurrencyTag = CGAL::Parallel_if_available_tag>
class Feature_detector
{
  typedef internal::Animation_access<Animation> Access;

public:
  typedef typename Animation::FT FT;                                      ///< of coordinates and fields
  typedef Spatio_temporal_field<FT> Field;                                ///< of strains, deformations, ...
  typedef typename Access::Sequence::vertex_descriptor vertex_descriptor; ///< of the animation's mesh
  typedef Spatio_temporal_feature<vertex_descriptor> Feature;             ///< what is found

  /// a `Frame_sequence` is used as it is; the positions of another model are read once, into a `Frame_sequence`, which
  /// takes `O(N F)` time and memory.
  /// \throw Input_error see `Frame_sequence`.
  explicit Feature_detector(const Animation& animation, Options options = Options())
    : m_access(animation)
    , m_options(std::move(options))
  {
  }

  /// what the detector was told, with the selection as it is now.
  const Options& options() const { return m_options; }

  /// which minima become features may be changed at any time.
  Feature_selection& selection() { return m_options.selection; }

  /// limits the memory of the space levels that are kept at a time, in bytes; by default there is no limit, and 18 levels
  /// of `N x F` doubles at most. At least 5 are kept. Fewer levels cost time, as two of each batch are searched twice;
  /// they do not change the result.
  void set_level_memory(std::size_t bytes) { m_level_memory = bytes; }

  /// \name Fields
  /// computed at the first call. The visitor is a model of `DetectionVisitor`.
  /// \throw Option_error if the radius of the balls is negative or not finite.
  /// \throw Numerical_error if a matrix cannot be factored.
  /// \throw Cancelled if the visitor asks for it.
  /// @{

  /// `N x F` strains.
  template <class Visitor>
  const Field& strain(Visitor& visitor)
  {
    if (!m_strain) m_strain = strain_rows(visitor);
    return *m_strain;
  }

  /// `N x F` absolute changes of curvature from the rest shape.
  template <class Visitor>
  const Field& curvature_change(Visitor& visitor)
  {
    if (!m_curvature_change) {
      const Compressed_rows& balls = geodesic_balls(visitor);
      const internal::Stage_scope<Visitor> stage(visitor, Stage::CURVATURE);
      m_curvature_change =
          internal::curvature_change_rows(animation(), balls, m_options.curvature, loop(visitor, Stage::CURVATURE));
    }
    return *m_curvature_change;
  }

  /// `N x F` deformations, in which features are found.
  template <class Visitor>
  const Field& deformation(Visitor& visitor)
  {
    if (!m_deformation) {
      if (m_options.alpha == 0) { // spares the balls
        m_deformation = strain(visitor);
      } else if (m_curvature_change) {
        m_deformation = Animated_mesh_features::deformation(strain(visitor), *m_curvature_change, m_options.alpha);
      } else {
        const Compressed_rows& balls = geodesic_balls(visitor);
        Field sum = m_strain ? *m_strain : strain_rows(visitor);
        const internal::Stage_scope<Visitor> stage(visitor, Stage::CURVATURE);
        internal::add_curvature_change(animation(), balls, m_options.curvature, m_options.alpha,
                                       loop(visitor, Stage::CURVATURE), sum);
        m_deformation = std::move(sum);
      }
    }
    return *m_deformation;
  }

  const Field& strain() { return strain(m_default_visitor); }                     ///< the same without a visitor
  const Field& curvature_change() { return curvature_change(m_default_visitor); } ///< the same without a visitor
  const Field& deformation() { return deformation(m_default_visitor); }           ///< the same without a visitor

  /// takes a field of the user's own, `N x F`, in place of the deformation: temperature, muscle activity, error of a
  /// simulation.
  /// \param field `N x F`, rows in the order of `vertices(mesh)`.
  /// \param noise responses that are at most that strong count as errors of the field.
  /// \throw Option_error if its shape is another or the noise is negative; Input_error if a value is not finite.
  void set_deformation(Field field, double noise = 0)
  {
    if (!(noise >= 0)) throw Option_error("the noise of a deformation must not be negative");
    internal::check_field(field, animation().number_of_vertices(), animation().number_of_frames());
    m_deformation = std::move(field);
    m_noise = noise;
    m_minima.reset();
  }

  /// the strength up to which a feature of the deformation may be an error that stems from the coordinates, because they
  /// are rounded; or that of the field of the user's own.
  double deformation_noise() const { return m_noise ? *m_noise : internal::deformation_noise(animation()); }

  /// the ball of each vertex on the rest shape.
  template <class Visitor>
  const Compressed_rows& geodesic_balls(Visitor& visitor)
  {
    if (!m_balls) {
      const internal::Stage_scope<Visitor> stage(visitor, Stage::GEODESIC_BALLS);
      const Rest_shape& shape = animation().rest;
      if (!(m_options.ball_radius >= 0) || !std::isfinite(m_options.ball_radius))
        throw Option_error("the radius of the geodesic balls must be positive");
      m_balls = m_options.balls(shape, m_options.ball_radius > 0 ? m_options.ball_radius : default_ball_radius(shape),
                                loop(visitor, Stage::GEODESIC_BALLS));
    }
    return *m_balls;
  }

  /// @}

  /*!
  writes the features to `out`, strongest first.

  Time: linear in `N F` times the number of space levels times the number of time levels, plus the spatial filter.
  Memory: up to 18 fields of `N x F` doubles, the space levels of a batch; see `set_level_memory()`.

  \param out an output iterator of `Feature`.
  \param visitor a model of `DetectionVisitor`.
  \throw Option_error if a threshold is out of its range, or the sampling finds no levels. Nothing is written if an
    exception is thrown.
  \throw Numerical_error if a matrix cannot be factored.
  \throw Cancelled if the visitor asks for it.
  */
  template <class OutputIterator, class Visitor>
  OutputIterator operator()(OutputIterator out, Visitor& visitor)
  {
    internal::check_selection(m_options.selection);
    if (!m_minima) find_minima(visitor);
    const std::vector<Feature> selected =
        internal::selected_features(animation().rest, *m_minima, m_options.selection);
    return std::copy(selected.begin(), selected.end(), out);
  }

  /// the same without a visitor.
  template <class OutputIterator>
  OutputIterator operator()(OutputIterator out)
  {
    return operator()(out, m_default_visitor);
  }

  /// the number of minima of the response, before thresholds and suppression, but above the rounding errors of the
  /// coordinates and of the smoothing, so that a body that moves rigidly has none; 0 before the first detection.
  std::size_t number_of_minima() const { return m_minima ? m_minima->size() : 0; }

  /// \name Levels of the last detection
  /// @{
  const std::vector<double>& sigma_levels() const { return m_sigma; } ///< the \f$\sigma\f$ of all space levels (length)
  const std::vector<double>& tau_levels() const { return m_tau; }     ///< the \f$\tau\f$ of all time levels (seconds)
  /// @}

private:
  const internal::Flat_animation<FT>& animation() const { return m_access->flat_animation(); }

  template <class Visitor>
  static internal::Task_loop<ConcurrencyTag, Visitor> loop(Visitor& visitor, Stage stage)
  {
    return internal::Task_loop<ConcurrencyTag, Visitor>(visitor, stage);
  }

  template <class Visitor>
  Field strain_rows(Visitor& visitor) const
  {
    const internal::Stage_scope<Visitor> stage(visitor, Stage::STRAIN);
    return internal::vertex_strain_rows(animation(), m_options.strain, m_options.triangle_weights,
                                        loop(visitor, Stage::STRAIN));
  }

  // A minimum has a level on either side, and all three have those of which their differences are made.
  static void check_number_of_levels(const Scale_levels& levels)
  {
    typedef typename Options::SpaceTimeResponse Response;
    constexpr std::size_t least = Response::below + Response::above + 3;
    if (levels.space_variances.size() < least || levels.time_variances.size() < least)
      throw Option_error("there are " + std::to_string(levels.space_variances.size()) + " space levels and " +
                         std::to_string(levels.time_variances.size()) + " time levels; at least " +
                         std::to_string(least) + " of each are needed");
  }

  template <class Visitor>
  void find_minima(Visitor& visitor)
  {
    const Field& field = deformation(visitor);
    const Rest_shape& shape = animation().rest;
    const std::size_t frames = animation().number_of_frames();
    const double clock = animation().frame_duration;
    const Scale_levels levels =
        m_options.sampling(shape, frames, clock, m_options.spatial_filter, m_options.temporal_filter);
    check_number_of_levels(levels);
    {
      const internal::Stage_scope<Visitor> stage(visitor, Stage::SCALE_SPACE);
      // a range of no length, so that the fraction is 0 until there are levels
      const internal::Task_loop<ConcurrencyTag, Visitor> preparation(visitor, Stage::SCALE_SPACE, 0, 0);
      m_options.spatial_filter.initialize(shape, levels.space_variances, preparation);
    }
    m_options.temporal_filter.initialize(frames, clock, levels.time_variances);
    m_sigma.clear();
    m_tau.clear();
    for (std::size_t k = 0; k < levels.space_variances.size(); ++k)
      m_sigma.push_back(levels.sigma_factor * std::sqrt(m_options.spatial_filter.variance(k)));
    for (std::size_t l = 0; l < levels.time_variances.size(); ++l)
      m_tau.push_back(levels.tau_factor * std::sqrt(m_options.temporal_filter.variance(l)));
    m_options.response.initialize(m_sigma, m_tau, levels);

    internal::Scale_space_engine<typename Options::TemporalFilter, typename Options::SpaceTimeResponse,
                                 typename Options::ExtremumSearch>
        engine(shape, frames, m_sigma.size(), m_tau.size(), m_options.temporal_filter, m_options.response,
               m_options.search);
    const std::size_t level_size = Spatio_temporal_field<double>::memory(shape.number_of_vertices(), frames);
    constexpr std::size_t around = Options::SpaceTimeResponse::below + Options::SpaceTimeResponse::above + 2;
    const std::size_t levels_in_memory = m_level_memory / level_size;
    engine.set_largest_batch(levels_in_memory > around ? levels_in_memory - around : 1);
    const double noise = deformation_noise();
    engine.set_least_response(noise);
    const std::vector<internal::Extremum> extrema =
        engine.template run<ConcurrencyTag>(field, m_options.spatial_filter, visitor);

    std::vector<Feature> minima;
    minima.reserve(extrema.size());
    for (const internal::Extremum& e : extrema)
      if (-e.response() > noise) minima.push_back(feature(e, levels));
    std::sort(minima.begin(), minima.end(), [](const Feature& a, const Feature& b) {
      return std::tie(a.response, a.vertex_index, a.time, a.sigma, a.tau) <
             std::tie(b.response, b.vertex_index, b.time, b.sigma, b.tau);
    });
    m_minima = std::move(minima);
  }

  Feature feature(const internal::Extremum& e, const Scale_levels& levels) const
  {
    typedef typename Options::SpaceTimeResponse Response;
    Feature result;
    result.vertex_index = e.vertex;
    result.vertex = m_access->vertex_descriptors()[e.vertex];
    const internal::Refined_scales scales = internal::refine_scales(e);
    const auto sigma = [&](std::size_t k) {
      return levels.sigma_factor * std::sqrt(m_options.spatial_filter.variance(k, e.vertex));
    };
    result.sigma = internal::interpolated_scale(sigma(e.k - 1), sigma(e.k), sigma(e.k + 1), scales.space_level);
    result.tau = internal::interpolated_scale(m_tau[e.l - 1], m_tau[e.l], m_tau[e.l + 1], scales.time_level);
    result.response = scales.response;
    const auto outermost = [](std::size_t i, std::size_t size) {
      return i == Response::below + 1 || i + Response::above + 2 == size;
    };
    result.at_scale_limit = outermost(e.k, m_sigma.size()) || outermost(e.l, m_tau.size());

    internal::place_feature(animation(), e, scales, result);
    return result;
  }

  Access m_access;
  Options m_options;
  Default_visitor m_default_visitor;
  std::optional<Compressed_rows> m_balls;
  std::optional<Field> m_strain, m_curvature_change, m_deformation;
  std::optional<double> m_noise; // of a field of the user's own
  std::optional<std::vector<Feature>> m_minima; // strongest first
  std::vector<double> m_sigma, m_tau;
  std::size_t m_level_memory = std::size_t(-1);
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_FEATURE_DETECTOR_H
