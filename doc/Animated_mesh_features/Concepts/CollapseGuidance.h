// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `CollapseGuidance` describes where and when the surface of an animated mesh matters more, or less, while the
mesh is simplified: a factor for the quadrics of a vertex in a pose, and for distances there when places are refined.

A model may be called from several threads at the same time.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Plain_guidance}
\cgalHasModels{CGAL::Animated_mesh_features::Feature_guidance}
\cgalHasModelsEnd
*/
class CollapseGuidance
{
public:
  /// how much the surface around a vertex matters in a frame, positive and always the same; asked for each vertex
  /// and pose, again each time that places are refined.
  /// \param vertex rank in `vertices(mesh)`.
  /// \param frame from 0.
  double operator()(std::size_t vertex, std::size_t frame) const;
};
