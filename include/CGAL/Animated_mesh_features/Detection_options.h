// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_OPTIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_OPTIONS_H

#include <CGAL/Animated_mesh_features/Box_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Curvature_measures.h>
#include <CGAL/Animated_mesh_features/Difference_of_gaussians.h>
#include <CGAL/Animated_mesh_features/Extremum_search.h>
#include <CGAL/Animated_mesh_features/Gaussian_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Heat_diffusion_filter.h>
#include <CGAL/Animated_mesh_features/Heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/One_ring_average_filter.h>
#include <CGAL/Animated_mesh_features/Scale_sampling.h>
#include <CGAL/Animated_mesh_features/Strain_measures.h>
#include <CGAL/Animated_mesh_features/deformation.h>
#include <CGAL/Animated_mesh_features/strain.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

Which minima of the response become features.
*/
struct Feature_selection
{
  /// the least strength, as a fraction of the strongest response found. In [0, 1].
  double relative_threshold = 0.2;

  /// the least strength, absolute. The stricter of the two thresholds decides.
  double absolute_threshold = 0;

  /// whether to drop what lies within max(sigma) on the surface and max(tau) in time of a stronger feature, if sigma
  /// and tau of the two are each within a factor of 1.5.
  bool suppress_non_maxima = true;

  /// whether features may lie on the border of the mesh, where the smoothing knows only one side.
  bool accept_border_vertices = true;
};

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
struct Detection_options
{
  /// \name Policies
  /// @{
  typedef StrainMeasure_ StrainMeasure;         ///< a model of the concept of this name
  typedef CurvatureMeasure_ CurvatureMeasure;   ///< a model of the concept of this name
  typedef GeodesicBalls_ GeodesicBalls;         ///< a model of the concept of this name
  typedef SpatialFilter_ SpatialFilter;         ///< a model of the concept of this name
  typedef TemporalFilter_ TemporalFilter;       ///< a model of the concept of this name
  typedef ScaleSampling_ ScaleSampling;         ///< a model of the concept of this name
  typedef SpaceTimeResponse_ SpaceTimeResponse; ///< a model of the concept of this name
  typedef ExtremumSearch_ ExtremumSearch;       ///< a model of the concept of this name

  StrainMeasure strain = StrainMeasure();            ///< the measure of the strain of a triangle
  CurvatureMeasure curvature = CurvatureMeasure();   ///< the measure of the curvature around a vertex
  GeodesicBalls balls = GeodesicBalls();             ///< the neighbourhoods in which curvature is measured
  SpatialFilter spatial_filter = SpatialFilter();    ///< the smoothing over the surface
  TemporalFilter temporal_filter = TemporalFilter(); ///< the smoothing over time
  ScaleSampling sampling = ScaleSampling();          ///< how much is smoothed: the levels of the scale space
  SpaceTimeResponse response = SpaceTimeResponse();  ///< what is made of the levels, and searched for minima
  ExtremumSearch search = ExtremumSearch();          ///< which samples of the response are minima
  /// @}

  /// how the strains of triangles are averaged at a vertex.
  Triangle_weights triangle_weights = Triangle_weights::REST_AREA;

  /// the radius of the geodesic balls (length); 0: `default_ball_radius()`.
  double ball_radius = 0;

  /// \f$\alpha\f$, the weight of the change of curvature against strain.
  double alpha = default_curvature_weight;

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
    return copy(p, curvature, balls, spatial_filter, temporal_filter, sampling, response, search);
  }

  /// the same options but for the measure of curvature.
  /// \tparam T a model of `CurvatureMeasure`.
  template <class T>
  auto with_curvature(const T& p) const
  {
    return copy(strain, p, balls, spatial_filter, temporal_filter, sampling, response, search);
  }

  /// the same options but for how geodesic balls are found.
  /// \tparam T a model of `GeodesicBalls`.
  template <class T>
  auto with_balls(const T& p) const
  {
    return copy(strain, curvature, p, spatial_filter, temporal_filter, sampling, response, search);
  }

  /// the same options but for the smoothing over the surface.
  /// \tparam T a model of `SpatialFilter`.
  template <class T>
  auto with_spatial_filter(const T& p) const
  {
    return copy(strain, curvature, balls, p, temporal_filter, sampling, response, search);
  }

  /// the same options but for the smoothing over time.
  /// \tparam T a model of `TemporalFilter`.
  template <class T>
  auto with_temporal_filter(const T& p) const
  {
    return copy(strain, curvature, balls, spatial_filter, p, sampling, response, search);
  }

  /// the same options but for the levels of the scale space.
  /// \tparam T a model of `ScaleSampling`.
  template <class T>
  auto with_sampling(const T& p) const
  {
    return copy(strain, curvature, balls, spatial_filter, temporal_filter, p, response, search);
  }

  /// the same options but for the response.
  /// \tparam T a model of `SpaceTimeResponse`.
  template <class T>
  auto with_response(const T& p) const
  {
    return copy(strain, curvature, balls, spatial_filter, temporal_filter, sampling, p, search);
  }

  /// the same options but for the search for minima.
  /// \tparam T a model of `ExtremumSearch`.
  template <class T>
  auto with_search(const T& p) const
  {
    return copy(strain, curvature, balls, spatial_filter, temporal_filter, sampling, response, p);
  }
  /// @}

private:
  template <class A, class B, class C, class D, class E, class F, class G, class H>
  Detection_options<A, B, C, D, E, F, G, H>
  copy(const A& a, const B& b, const C& c, const D& d, const E& e, const F& f, const G& g, const H& h) const
  {
    return {a, b, c, d, e, f, g, h, triangle_weights, ball_radius, alpha, selection};
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

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_OPTIONS_H
