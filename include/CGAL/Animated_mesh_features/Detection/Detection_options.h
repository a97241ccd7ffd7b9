// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_DETECTION_OPTIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_DETECTION_OPTIONS_H

#include <CGAL/Animated_mesh_features/Deformation/Deformation_options.h>
#include <CGAL/Animated_mesh_features/Deformation/subtract_baseline.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_selection.h>
#include <CGAL/Animated_mesh_features/Extrema/Extremum_options.h>
#include <CGAL/Animated_mesh_features/Scale_space/Box_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/One_ring_average_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Planar_normalization.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

Everything that a detection can be told: a policy for each step, and numbers. The function `calibrated_options()`
returns the defaults, `published_options()` the paper's choices; `with_...()` returns the same options with one policy
replaced by another, which may be of the user's own class.

The defaults of the numbers are those of both presets, but for `triangle_weights`, `selection` and
`Difference_of_gaussians_minima::join_equal`, see `published_options()`.

\tparam StrainMeasure_ a model of `StrainMeasure`.
\tparam CurvatureMeasure_ a model of `CurvatureMeasure`.
\tparam GeodesicBalls_ a model of `GeodesicBalls`.
\tparam SpatialFilter_ a model of `SpatialFilter`.
\tparam TemporalFilter_ a model of `TemporalFilter`.
\tparam ScaleSampling_ a model of `ScaleSampling`.
\tparam SpaceTimeResponse_ a model of `SpaceTimeResponse`.
\tparam ExtremumSearch_ a model of `ExtremumSearch`.
\tparam ScaleNormalization_ a model of `ScaleNormalization`.
\tparam Baseline_ a model of `Baseline`.
*/
template <class StrainMeasure_,
          class CurvatureMeasure_,
          class GeodesicBalls_,
          class SpatialFilter_,
          class TemporalFilter_,
          class ScaleSampling_,
          class SpaceTimeResponse_,
          class ExtremumSearch_,
          class ScaleNormalization_ = Heat_kernel_normalization,
          class Baseline_ = Least_value_baseline>
struct Detection_options : Deformation_options<StrainMeasure_, CurvatureMeasure_, GeodesicBalls_>,
                           Extremum_options<SpatialFilter_, TemporalFilter_, ScaleSampling_, SpaceTimeResponse_,
                                            ExtremumSearch_, ScaleNormalization_>
{
  /// the options of the first stage, `Deformation_measurement`.
  typedef Deformation_options<StrainMeasure_, CurvatureMeasure_, GeodesicBalls_> Measurement;

  /// the options of the second stage, `find_response_extrema()` and `Feature_detector`.
  typedef Extremum_options<SpatialFilter_, TemporalFilter_, ScaleSampling_, SpaceTimeResponse_, ExtremumSearch_,
                           ScaleNormalization_>
      Search;

  typedef Baseline_ Baseline; ///< a model of the concept of this name

  /// the defaults of both stages.
  Detection_options() = default;

  /// puts the options of both stages together.
  Detection_options(Measurement measurement, Search search, Feature_selection selection = Feature_selection(),
                    Baseline baseline = Baseline())
    : Measurement(std::move(measurement))
    , Search(std::move(search))
    , baseline(std::move(baseline))
    , selection(selection)
  {
  }

  /// what is subtracted from the field between the two stages.
  Baseline baseline;

  /// thresholds and suppression.
  Feature_selection selection;

  /// \name Replacing a policy
  /// Each returns options of another type, with everything else unchanged.
  /// @{

  /// the same options but for the measure of strain.
  /// \tparam T a model of `StrainMeasure`.
  template <class T>
  auto with_strain(const T& p) const
  {
    return measuring(p, this->curvature, this->balls);
  }

  /// the same options but for the measure of curvature.
  /// \tparam T a model of `CurvatureMeasure`.
  template <class T>
  auto with_curvature(const T& p) const
  {
    return measuring(this->strain, p, this->balls);
  }

  /// the same options but for how geodesic balls are found.
  /// \tparam T a model of `GeodesicBalls`.
  template <class T>
  auto with_balls(const T& p) const
  {
    return measuring(this->strain, this->curvature, p);
  }

  /// the same options but for the smoothing over the surface.
  /// \tparam T a model of `SpatialFilter`.
  template <class T>
  auto with_spatial_filter(const T& p) const
  {
    return searching(p, this->temporal_filter, this->sampling, this->response, this->search, this->normalization);
  }

  /// the same options but for the smoothing over time.
  /// \tparam T a model of `TemporalFilter`.
  template <class T>
  auto with_temporal_filter(const T& p) const
  {
    return searching(this->spatial_filter, p, this->sampling, this->response, this->search, this->normalization);
  }

  /// the same options but for the levels of the scale space.
  /// \tparam T a model of `ScaleSampling`.
  template <class T>
  auto with_sampling(const T& p) const
  {
    return searching(this->spatial_filter, this->temporal_filter, p, this->response, this->search, this->normalization);
  }

  /// the same options but for the response.
  /// \tparam T a model of `SpaceTimeResponse`.
  template <class T>
  auto with_response(const T& p) const
  {
    return searching(this->spatial_filter, this->temporal_filter, this->sampling, p, this->search, this->normalization);
  }

  /// the same options but for the search for minima.
  /// \tparam T a model of `ExtremumSearch`.
  template <class T>
  auto with_search(const T& p) const
  {
    return searching(this->spatial_filter, this->temporal_filter, this->sampling, this->response, p, this->normalization);
  }

  /// the same options but for how responses are normalised to the surface's dimension.
  /// \tparam T a model of `ScaleNormalization`.
  template <class T>
  auto with_normalization(const T& p) const
  {
    return searching(this->spatial_filter, this->temporal_filter, this->sampling, this->response, this->search, p);
  }

  /// the same options but for what is subtracted from the field.
  /// \tparam T a model of `Baseline`.
  template <class T>
  auto with_baseline(const T& p) const
  {
    return Detection_options<StrainMeasure_, CurvatureMeasure_, GeodesicBalls_, SpatialFilter_, TemporalFilter_,
                             ScaleSampling_, SpaceTimeResponse_, ExtremumSearch_, ScaleNormalization_, T>(
        *this, *this, selection, p);
  }
  /// @}

private:
  // The options of a stage with one policy replaced: everything but the policies is taken from this.
  template <class S, class C, class B>
  Detection_options<S, C, B, SpatialFilter_, TemporalFilter_, ScaleSampling_, SpaceTimeResponse_, ExtremumSearch_,
                    ScaleNormalization_, Baseline_>
  measuring(const S& s, const C& c, const B& b) const
  {
    return {{s, c, b, this->triangle_weights, this->ball_radius, this->alpha}, *this, selection, baseline};
  }
  template <class S, class T, class L, class R, class E, class N>
  Detection_options<StrainMeasure_, CurvatureMeasure_, GeodesicBalls_, S, T, L, R, E, N, Baseline_>
  searching(const S& s, const T& t, const L& l, const R& r, const E& e, const N& n) const
  {
    return {*this, {s, t, l, r, e, n, this->level_memory}, selection, baseline};
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

The options of the preset `calibrated`, the default.
*/
typedef Detection_options<Hencky_strain,
                          Mean_curvature_density,
                          Heat_method_geodesic_balls,
                          Heat_diffusion_filter,
                          Gaussian_temporal_filter,
                          Fixed_ratio_sampling,
                          Central_difference_of_gaussians,
                          Difference_of_gaussians_minima>
    Calibrated_options;

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

The options of the preset `published`.
*/
typedef Detection_options<Largest_eigenvalue_strain,
                          Mean_dihedral_angle,
                          Heat_method_geodesic_balls,
                          One_ring_average_filter,
                          Box_temporal_filter,
                          Every_smoothing_count,
                          Forward_difference_of_gaussians,
                          Difference_of_gaussians_minima,
                          Planar_normalization,
                          No_baseline>
    Published_options;

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

The default: measures that see compression and converge under refinement, what never changes taken from them, filters of
known variance, responses normalised to the surface's dimension, scales in units that do not depend on the sampling,
thresholds in the unit of the field, the fit, and suppression.
*/
inline Calibrated_options calibrated_options() { return Calibrated_options(); }

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

The method in the words of Mykhalchuk, Seo and Cordier \cgalCite{mykhalchuk2014}, for comparison: largest eigenvalue of
the Cauchy-Green tensor, plain mean over triangles, mean of dihedral angles, every smoothing count of one-ring averages
and box averages, forward differences on a plane, no baseline, no fit, no suppression; at least a fifth of the strongest
response. Lengths in Eq. (7) need a unit, see `Every_smoothing_count`.

\param box_width width of the temporal box in frames; the paper's Table 1 has 5 to 20, for a sixth to a tenth of the
frames.
\sa `published_box_width()`
*/
inline Published_options published_options(std::size_t box_width)
{
  Published_options options;
  options.sampling.box_width = box_width;
  options.spatial_filter = One_ring_average_filter(false);
  options.temporal_filter = Box_temporal_filter(box_width);
  options.triangle_weights = Triangle_weights::UNIFORM;
  options.search.join_equal = false;
  options.selection = Feature_selection::of_any_field();
  options.selection.min_fit = 0;
  options.selection.suppress_non_maxima = false;
  return options;
}

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

a sixth of the number of frames, at least 2: the paper's 8 for the horse's 48 frames.
*/
inline std::size_t published_box_width(std::size_t number_of_frames)
{
  return (std::max)(std::size_t(2), std::size_t(std::lround(double(number_of_frames) / 6)));
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_DETECTION_OPTIONS_H
