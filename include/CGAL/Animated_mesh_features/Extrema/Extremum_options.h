// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_EXTREMUM_OPTIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_EXTREMUM_OPTIONS_H

#include <CGAL/Animated_mesh_features/Extrema/Extremum_search.h>
#include <CGAL/Animated_mesh_features/Scale_space/Difference_of_gaussians.h>
#include <CGAL/Animated_mesh_features/Scale_space/Gaussian_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Heat_diffusion_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Heat_kernel_normalization.h>
#include <CGAL/Animated_mesh_features/Scale_space/Scale_sampling.h>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesExtrema

What a search for extrema in the scale space of a field can be told: a policy for each step.

\tparam SpatialFilter_ a model of `SpatialFilter`.
\tparam TemporalFilter_ a model of `TemporalFilter`.
\tparam ScaleSampling_ a model of `ScaleSampling`.
\tparam SpaceTimeResponse_ a model of `SpaceTimeResponse`.
\tparam ExtremumSearch_ a model of `ExtremumSearch`.
\sa `find_response_extrema()`
*/
template <class SpatialFilter_ = Heat_diffusion_filter,
          class TemporalFilter_ = Gaussian_temporal_filter,
          class ScaleSampling_ = Fixed_ratio_sampling,
          class SpaceTimeResponse_ = Central_difference_of_gaussians,
          class ExtremumSearch_ = Difference_of_gaussians_minima,
          class ScaleNormalization_ = Heat_kernel_normalization>
struct Extremum_options
{
  typedef SpatialFilter_ SpatialFilter;         ///< a model of the concept of this name
  typedef TemporalFilter_ TemporalFilter;       ///< a model of the concept of this name
  typedef ScaleSampling_ ScaleSampling;         ///< a model of the concept of this name
  typedef SpaceTimeResponse_ SpaceTimeResponse; ///< a model of the concept of this name
  typedef ExtremumSearch_ ExtremumSearch;       ///< a model of the concept of this name
  typedef ScaleNormalization_ ScaleNormalization; ///< a model of the concept of this name

  SpatialFilter spatial_filter = SpatialFilter();    ///< the smoothing over the surface
  TemporalFilter temporal_filter = TemporalFilter(); ///< the smoothing over time
  ScaleSampling sampling = ScaleSampling();          ///< how much is smoothed: the levels of the scale space
  SpaceTimeResponse response = SpaceTimeResponse();  ///< what is made of the levels, and searched for minima
  ExtremumSearch search = ExtremumSearch();          ///< which samples of the response are minima
  ScaleNormalization normalization = ScaleNormalization(); ///< by which factor responses fall with the scale

  /// limits the memory of the space levels that are kept at a time, in bytes; by default there is no limit, and 18 levels
  /// of `N x F` doubles at most. At least 5 are kept. Fewer levels cost time, as two of each batch are searched twice;
  /// they do not change the result.
  std::size_t level_memory = std::size_t(-1);
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_EXTREMUM_OPTIONS_H
