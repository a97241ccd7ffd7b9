// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_DETECTION_OPTIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_DETECTION_OPTIONS_H

#include <CGAL/Animated_mesh_features/Deformation/Deformation_options.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_selection.h>
#include <CGAL/Animated_mesh_features/Extrema/Extremum_options.h>
#include <CGAL/Animated_mesh_features/Scale_space/Box_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/One_ring_average_filter.h>

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

The defaults of the numbers are those of both presets, but for `triangle_weights`, which is `Triangle_weights::UNIFORM`
in `published_options()`, and `Feature_selection::suppress_non_maxima`, which is `false` there.

\tparam StrainMeasure_ a model of `StrainMeasure`.
\tparam CurvatureMeasure_ a model of `CurvatureMeasure`.
\tparam GeodesicBalls_ a model of `GeodesicBalls`.
\tparam SpatialFilter_ a model of `SpatialFilter`.
\tparam TemporalFilter_ a model of `TemporalFilter`.
\tparam ScaleSampling_ a model of `ScaleSampling`.
\tparam SpaceTimeResponse_ a model of `SpaceTimeResponse`.
\tparam ExtremumSearch_ a model of `ExtremumSearch`.
*/
template <class StrainMeasure_,
          class CurvatureMeasure_,
          class GeodesicBalls_,
          class SpatialFilter_,
          class TemporalFilter_,
          class ScaleSampling_,
          class SpaceTimeResponse_,
          class ExtremumSearch_>
struct Detection_options : Deformation_options<StrainMeasure_, CurvatureMeasure_, GeodesicBalls_>,
                           Extremum_options<SpatialFilter_, TemporalFilter_, ScaleSampling_, SpaceTimeResponse_, ExtremumSearch_>
{
  /// the options of the first stage, `Deformation_measurement`.
  typedef Deformation_options<StrainMeasure_, CurvatureMeasure_, GeodesicBalls_> Measurement;

  /// the options of the second stage, `find_response_extrema()` and `Feature_detector`.
  typedef Extremum_options<SpatialFilter_, TemporalFilter_, ScaleSampling_, SpaceTimeResponse_, ExtremumSearch_> Search;

  /// the defaults of both stages.
  Detection_options() = default;

  /// puts the options of both stages together.
  Detection_options(Measurement measurement, Search search, Feature_selection selection = Feature_selection())
    : Measurement(std::move(measurement))
    , Search(std::move(search))
    , selection(selection)
  {
  }

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
    return searching(p, this->temporal_filter, this->sampling, this->response, this->search);
  }

  /// the same options but for the smoothing over time.
  /// \tparam T a model of `TemporalFilter`.
  template <class T>
  auto with_temporal_filter(const T& p) const
  {
    return searching(this->spatial_filter, p, this->sampling, this->response, this->search);
  }

  /// the same options but for the levels of the scale space.
  /// \tparam T a model of `ScaleSampling`.
  template <class T>
  auto with_sampling(const T& p) const
  {
    return searching(this->spatial_filter, this->temporal_filter, p, this->response, this->search);
  }

  /// the same options but for the response.
  /// \tparam T a model of `SpaceTimeResponse`.
  template <class T>
  auto with_response(const T& p) const
  {
    return searching(this->spatial_filter, this->temporal_filter, this->sampling, p, this->search);
  }

  /// the same options but for the search for minima.
  /// \tparam T a model of `ExtremumSearch`.
  template <class T>
  auto with_search(const T& p) const
  {
    return searching(this->spatial_filter, this->temporal_filter, this->sampling, this->response, p);
  }
  /// @}

private:
  // The options of a stage with one policy replaced: everything but the policies is taken from this.
  template <class S, class C, class B>
  Detection_options<S, C, B, SpatialFilter_, TemporalFilter_, ScaleSampling_, SpaceTimeResponse_, ExtremumSearch_>
  measuring(const S& s, const C& c, const B& b) const
  {
    return {{s, c, b, this->triangle_weights, this->ball_radius, this->alpha}, *this, selection};
  }
  template <class S, class T, class L, class R, class E>
  Detection_options<StrainMeasure_, CurvatureMeasure_, GeodesicBalls_, S, T, L, R, E>
  searching(const S& s, const T& t, const L& l, const R& r, const E& e) const
  {
    return {*this, {s, t, l, r, e, this->level_memory}, selection};
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
                          Difference_of_gaussians_minima>
    Published_options;

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

The default: measures that see compression and converge under refinement, filters of known variance, scales in units
that do not depend on the sampling, thresholds and suppression.
*/
inline Calibrated_options calibrated_options() { return Calibrated_options(); }

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

The method in the words of Mykhalchuk, Seo and Cordier \cgalCite{mykhalchuk2014}, for comparison: largest eigenvalue of
the Cauchy-Green tensor, plain mean over triangles, mean of dihedral angles, every smoothing count of one-ring averages
and box averages, forward differences, no suppression. Lengths in Eq. (7) need a unit, see `Every_smoothing_count`.

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
