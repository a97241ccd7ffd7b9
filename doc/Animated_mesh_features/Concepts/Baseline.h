// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `Baseline` describes what is subtracted from the values of a vertex before features are looked for: something
that does not depend on time.

A model is copy-constructible. It may be called from several threads at the same time.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Least_value_baseline}
\cgalHasModels{CGAL::Animated_mesh_features::No_baseline}
\cgalHasModelsEnd
*/
class Baseline
{
public:
  /// what is subtracted from the `number_of_frames` values of a vertex, of which there is at least one.
  /// \tparam FT `float` or `double`, the scalar of the field.
  template <class FT>
  FT operator()(const FT* row, std::size_t number_of_frames) const;
};
