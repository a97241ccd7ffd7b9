// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `TemporalFilter` describes the smoothing of a field over time, each vertex on its own, to a sequence of
levels that are smoother and smoother.

The smoothing is linear, and the same at all vertices: apart from smoothing rows, the library smooths unit impulses, and
uses the matrix of the filter that results. Together with a `SpatialFilter`, which acts on frames, it then does not
matter which of the two comes first.

A model is copy-constructible.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Gaussian_temporal_filter}
\cgalHasModels{CGAL::Animated_mesh_features::Box_temporal_filter}
\cgalHasModelsEnd

\sa `SpatialFilter`
\sa `ScaleSampling`
*/
class TemporalFilter
{
public:
  /*!
  prepares the levels, before any of them is asked for; may be called again, with other ones.

  \param number_of_frames of each row.
  \param frame_duration seconds.
  \param variances for each level the variance \f$\tau^2\f$ of the smoothing, with respect to the row that is not
    smoothed; ascending; squared seconds. A model need not attain them exactly.
  */
  void initialize(std::size_t number_of_frames, double frame_duration, const std::vector<double>& variances);

  /// the variance that level `l` attains. Positive but for a level that is not smoothed, ascending.
  double variance(std::size_t l) const;

  /*!
  makes level `l` of a row from level `l` - 1, or, for `l` = 0, from the row that is not smoothed. Called from several
  threads at the same time, for any row and level.

  \tparam T `double`; for a model with `vectorized`, also packs of several `float` or `double`.
  \param l the level.
  \param in, out `number_of_frames` values each; they do not overlap.
  */
  template <class T>
  void operator()(std::size_t l, const T* in, T* out) const;

  /// \name What Cyclic Animations Need
  /// Optional; see `CGAL::Animated_mesh_features::is_periodic()`.
  /// @{

  /// whether the filter continues a row by itself, ... F-2 F-1 | 0 1 2 ...: the last frame is followed by the first. Then
  /// the search and all that is measured in time goes on across the end, too. Without it: `false`.
  bool is_periodic() const;

  /// @}

  /// \name What Makes the Search Fast
  /// Optional. Without it, and with it, the same extrema are found.
  /// @{

  /// `true`: `operator()` may be called with packs of numbers as `T`, values of several rows in one frame. They have a
  /// default value without meaning and copies, `T + T`, `T - T` and `T * T::Scalar`, where `T::Scalar` is `float` or
  /// `double`; of the sum of absolute weights times the largest value, at most some rounding errors of `T::Scalar` may be
  /// lost by a step. What the model calls on the way should be inlined.
  static constexpr bool vectorized = true;

  /// whether every level l > 0 is level l - 1 after one and the same operation. Then differences of levels are smoothed
  /// in single precision, however close the levels are. Needed with `vectorized`.
  bool has_equal_steps() const;

  /// @}

  /// \name What Long Animations Need
  /// Optional, for filters that weigh frames by their distance. Without it, time and memory grow with the square of the
  /// number of frames.
  /// @{

  /// whether the filter continues a row by its mirror image, ... 1 0 | 0 1 2 ..., and weighs by distance only. (It may
  /// depend on a parameter of the filter.)
  bool reflects() const;

  /// the weights of level `l` with respect to the row that is not smoothed, by distance on the circle of 2 F frames on
  /// which a row and its mirror image live: at most F + 1 of them, the rest being zero; the weight of a frame of the row
  /// in another is the sum of those of its distance and of the distance of its mirror image. With `is_periodic()`, by
  /// distance on the circle of F frames, at most F / 2 + 1 of them. Called if one of the two is true, from several threads.
  std::vector<double> weights_by_distance(std::size_t l) const;

  /// @}

  /// \name What Samplings Ask For
  /// Needed only with a `ScaleSampling` that asks for it; may be called before `initialize()`.
  /// @{

  /// the variance that one step of smoothing adds, in squared seconds. Asked for by
  /// `CGAL::Animated_mesh_features::Every_smoothing_count`, whose levels are multiples of it.
  double unit_variance(std::size_t number_of_frames, double frame_duration) const;

  /// @}
};
