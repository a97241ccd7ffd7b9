// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `ScaleSampling` describes the choice of levels at which the scale space is computed: how much is smoothed,
in space and in time.

A model is copy-constructible.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Fixed_ratio_sampling}
\cgalHasModels{CGAL::Animated_mesh_features::Every_smoothing_count}
\cgalHasModelsEnd
*/
class ScaleSampling
{
public:
  /*!
  chooses the levels.

  A model may ask the filters what they can do, by functions of its own choice; it then works with filters that have
  them only. The filters' levels are not prepared yet.

  \param shape the rest shape.
  \param number_of_frames of the animation.
  \param frame_duration seconds.
  \param spatial a model of `SpatialFilter`.
  \param temporal a model of `TemporalFilter`.

  \returns the levels. Each of the two sequences has at least `SpaceTimeResponse::below + SpaceTimeResponse::above + 3`
    elements, or `CGAL::Animated_mesh_features::Option_error` is thrown: a minimum between scales has a level on either
    side, and the response of all three is a difference. Minima are found at all levels but those. Which scales are reported,
    and how much they count, are members, too.
  */
  template <class SpatialFilter, class TemporalFilter>
  CGAL::Animated_mesh_features::Scale_levels operator()(const CGAL::Animated_mesh_features::Rest_shape& shape,
                                                        std::size_t number_of_frames,
                                                        double frame_duration,
                                                        const SpatialFilter& spatial,
                                                        const TemporalFilter& temporal) const;
};
