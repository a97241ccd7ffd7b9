// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `SpaceTimeResponse` describes how the levels \f$L_{k,l}\f$ of the scale space are combined to a response
whose minima are the features, a weighted sum of a difference in space and one in time:
\f[ D_{k,l} = a_{k,l}\,(L_{k+p,l} - L_{k-q,l}) + b_{k,l}\,(L_{k,l+p} - L_{k,l-q}) . \f]

A model is copy-constructible.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Central_difference_of_gaussians}
\cgalHasModels{CGAL::Animated_mesh_features::Forward_difference_of_gaussians}
\cgalHasModelsEnd
*/
class SpaceTimeResponse
{
public:
  /// q, how many levels down the differences reach.
  static constexpr std::size_t below;

  /// p, how many levels up they reach.
  static constexpr std::size_t above;

  /*!
  is told the scales, before any weight is asked for; may be called again, with other ones.

  \param sigma the spatial scale \f$\sigma\f$ of each level (length), as it is reported; ascending.
  \param tau the temporal scale \f$\tau\f$ of each level (seconds), as it is reported; ascending.
  \param levels what the sampling asked for, with the units of the response.
  */
  void initialize(const std::vector<double>& sigma,
                  const std::vector<double>& tau,
                  const CGAL::Animated_mesh_features::Scale_levels& levels);

  /// \name Weights
  /// Called from several threads at the same time, for `k` and `l` from `below` to the last level but `above`.
  /// @{

  /// \f$a_{k,l}\f$
  double space_weight(std::size_t k, std::size_t l) const;

  /// \f$b_{k,l}\f$
  double time_weight(std::size_t k, std::size_t l) const;

  /// @}
};
