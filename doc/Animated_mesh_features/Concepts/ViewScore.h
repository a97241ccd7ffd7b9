// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `ViewScore` describes what is to be seen of an animation, and how much of it a view shows.

What is to be seen is divided into items, each of one frame and with a weight: vertices in the regions of features, for
instance, or the frame as a whole. The score of a view is the weighted mean of what it shows of each item; what several views
show together is, of each item, what that one shows which shows most of it.

Its operator is called from several threads at the same time.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Feature_view_score}
\cgalHasModels{CGAL::Animated_mesh_features::Entropy_view_score}
\cgalHasModels{CGAL::Animated_mesh_features::Area_view_score}
\cgalHasModelsEnd
*/
class ViewScore
{
public:
  /// the number of frames that are looked at, `K`.
  std::size_t number_of_frames() const;

  /// where the items of the `k`-th frame begin, which end where those of the next one do; from 0 for `k = 0` to the number of
  /// all items for `k = K`.
  std::size_t first_item(std::size_t k) const;

  /// what an item is worth, not negative.
  double weight(std::size_t item) const;

  /// sets `seen[0]`, `seen[1]` ... to how much is seen of the items of the frame that is looked at,
  /// `view.frame_rank()`: from 0 to 1.
  void operator()(const CGAL::Animated_mesh_features::Surface_view& view, float* seen) const;
};
