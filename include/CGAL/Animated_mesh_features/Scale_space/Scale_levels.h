// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_SCALE_LEVELS_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_SCALE_LEVELS_H

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesScaleSpace

A range of scales. Where it is an option, a bound of 0 stands for the default of the class that uses it.
*/
struct Scale_range
{
  double min = 0; ///< the smallest scale at which features are found
  double max = 0; ///< the largest

  /// whether a scale is in the range, up to rounding.
  bool contains(double scale) const { return scale >= min * (1 - 1e-9) && scale <= max * (1 + 1e-9); }
};

/*!
\ingroup PkgAnimatedMeshFeaturesScaleSpace

How much an extremum counts where a range of scales begins: nothing at `from`, all at `full` and above, in between by the
logarithm of its scale. Without, it would count for all or nothing by the last digit of its scale, and be found in one of
two animations alone that differ by next to nothing.
*/
struct Scale_fade
{
  double from = 0; ///< the scale up to which nothing counts
  double full = 0; ///< the scale from which on all counts; up to `from`: everything counts

  /// the share of a scale, in [0, 1].
  double operator()(double scale) const
  {
    if (!(scale < full) || !(from < full)) return 1;
    return scale > from ? std::log(scale / from) / std::log(full / from) : 0;
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesScaleSpace

The levels of a scale space, as a model of `ScaleSampling` asks for them.

A filter need not attain a variance exactly (a number of averages is an integer); what it attains it says itself, and
the scales that are reported follow it: \f$\sigma\f$ is `sigma_factor` times the square root of the variance attained.
*/
struct Scale_levels
{
  /// the variance per axis \f$s = \sigma^2\f$ of each space level, ascending; squared length.
  std::vector<double> space_variances;

  /// the variance \f$u = \tau^2\f$ of each time level, ascending; squared seconds.
  std::vector<double> time_variances;

  /// the reported \f$\sigma\f$ over the standard deviation of the spatial filter; 1 unless a method names its scales
  /// otherwise.
  double sigma_factor = 1;

  /// likewise for \f$\tau\f$.
  double tau_factor = 1;

  /// \name Scales that are reported
  /// An extremum is refined between the levels; what lies outside of these ranges then is dropped.
  /// @{
  Scale_range reported_sigma = {0, std::numeric_limits<double>::infinity()}; ///< length
  Scale_range reported_tau = {0, std::numeric_limits<double>::infinity()};   ///< seconds
  /// @}

  /// \name Where ranges begin
  /// The strength of a feature is multiplied by its share of both.
  /// @{
  Scale_fade sigma_fade; ///< length; by default all scales count
  Scale_fade tau_fade;   ///< seconds; likewise
  /// @}

  /// \name Units of the response
  /// The spatial and the temporal term of the scale-normalised difference of Gaussians have different dimensions, so
  /// that a length and a time have to be chosen in which \f$\sigma\f$ and \f$\tau\f$ are measured there.
  /// @{
  double unit_length = 1; ///< length
  double unit_time = 1;   ///< seconds
  /// @}
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_SCALE_LEVELS_H
