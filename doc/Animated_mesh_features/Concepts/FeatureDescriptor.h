// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `FeatureDescriptor` describes how the field around a feature becomes numbers that can be compared with those
of other features, by their Euclidean distance.

A model is copy-constructible. It may be called from several threads at the same time.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Rotation_free_gradient_histogram}
\cgalHasModels{CGAL::Animated_mesh_features::Oriented_gradient_histogram}
\cgalHasModelsEnd

\sa `CGAL::Animated_mesh_features::describe_features()`
*/
class FeatureDescriptor
{
public:
  /// how many numbers there are, the same for all features.
  std::size_t length() const;

  /*!
  describes a feature.

  The direction of the neighbourhood's first axis is arbitrary: what is not to depend on it must not use it, or replace
  it by one that follows from the samples.

  \param neighbourhood the samples of the field around the feature.
  \param out receives `length()` numbers.
  */
  void operator()(const CGAL::Animated_mesh_features::Feature_neighbourhood& neighbourhood, float* out) const;
};
