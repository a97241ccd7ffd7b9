// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `SpatialFilter` describes the smoothing of a field over the surface, each frame on its own, to a sequence of
levels that are smoother and smoother.

A model is copy-constructible. All functions are called from one thread; only the tasks that are given to `loop` run on
several.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Heat_diffusion_filter}
\cgalHasModels{CGAL::Animated_mesh_features::One_ring_average_filter}
\cgalHasModelsEnd

\sa `TemporalFilter`
\sa `ScaleSampling`
*/
class SpatialFilter
{
public:
  /*!
  prepares the levels, before any of them is asked for; may be called again, with other ones.

  \param shape the rest shape; lives until the last level is made.
  \param variances for each level the variance per axis \f$\sigma^2\f$ of the smoothing, with respect to the field that
    is not smoothed; ascending; squared length. A model need not attain them exactly.
  \tparam Loop a model of `TaskLoop`.
  \param loop runs tasks. The visitor's fraction stays 0 meanwhile.
  */
  template <class Loop>
  void initialize(const CGAL::Animated_mesh_features::Rest_shape& shape,
                  const std::vector<double>& variances,
                  const Loop& loop);

  /// the variance that level `k` attains; in the mean, if it varies. Positive but for a level that is not smoothed,
  /// ascending.
  double variance(std::size_t k) const;

  /// the variance that level `k` attains at vertex `v`, from which the scale of a feature is told.
  double variance(std::size_t k, std::size_t v) const;

  /*!
  makes level `k` of all frames from level `k` - 1, or, for `k` = 0, from the field that is not smoothed. The levels are
  asked for in turn, each of them once.

  The result in a frame depends on that frame only. For the result not to depend on threads, each value has to be
  computed by the same operations in the same order, whoever computes it.

  \param k the level.
  \param in, out different fields of `N x F`, rows in the order of `shape`; in double precision, whatever the scalar of
    the animation. What is in `out` before is not to be relied on.
  \param loop runs tasks.
  */
  template <class Loop>
  void operator()(std::size_t k,
                  const CGAL::Animated_mesh_features::Spatio_temporal_field<double>& in,
                  CGAL::Animated_mesh_features::Spatio_temporal_field<double>& out,
                  const Loop& loop);

  /// \name What Samplings Ask For
  /// Needed only with a `ScaleSampling` that asks for it; may be called before `initialize()`.
  /// @{

  /// the smallest variance that a level can have, in squared length. Asked for by
  /// `CGAL::Animated_mesh_features::Fixed_ratio_sampling`.
  double smallest_variance(const CGAL::Animated_mesh_features::Rest_shape& shape) const;

  /// the variance that one step of smoothing adds, in squared length. Asked for by
  /// `CGAL::Animated_mesh_features::Every_smoothing_count`, whose levels are multiples of it.
  double unit_variance(const CGAL::Animated_mesh_features::Rest_shape& shape) const;

  /// @}
};
