// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `ExtremumSearch` describes which samples of the response - at a vertex, in a frame, at a spatial and a
temporal scale - are minima. Samples of the first and the last frame, and of the outermost scales, are never asked
about.

A sample that is accepted is refined between samples as a minimum. Its strength is the negative of its response, so that
samples with a positive response do not become features.

A sample whose response is at most \f$2^{-30} (|a| + |b|) \max|d|\f$, for the weights a and b of the response and the field
d, is none, whatever a model says: a hundredth of what single precision rounds.

A model is copy-constructible. Its functions are called from several threads at the same time, with `double` as `FT`.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Difference_of_gaussians_minima}
\cgalHasModelsEnd
*/
class ExtremumSearch
{
public:
  /// whether the sample in the middle of the window may be a minimum, by the responses at its own vertex. Without
  /// `strict_minima`, this test sees all samples, and should reject nearly all of them.
  template <class FT>
  bool at_vertex(const CGAL::Animated_mesh_features::Response_window<FT>& window) const;

  /*!
  whether a sample may be a minimum, by the responses at one of the neighbours of its vertex, at the same scales.
  Called for one neighbour after the other, up to the first that objects.

  \param centre the response at the sample.
  \param before, same, after the responses at the neighbour in the frame before, in the same frame, and in the frame
    after it.
  */
  template <class FT>
  bool at_neighbour(FT centre, FT before, FT same, FT after) const;

  /// \name What Makes the Search Fast
  /// Optional.
  /// @{

  /// `true`: `at_vertex()` accepts only samples that are below zero, below the samples of the frames before and after at
  /// the same scales, and below the same sample at the eight neighbouring scales. Such samples are looked for in vector
  /// registers, and `at_vertex()` sees only those.
  static constexpr bool strict_minima = true;

  /// @}
};
