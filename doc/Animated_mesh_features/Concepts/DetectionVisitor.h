// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `DetectionVisitor` describes who is told of the progress of a detection, and may cancel it.

All functions are called from the thread that called the detector, and from no other: they may print, draw or look at a
user interface without locking.

`CGAL::Animated_mesh_features::Deformation_measurement` and `CGAL::Animated_mesh_features::Feature_detector` take their
visitor by reference, and ask for nothing else;
`CGAL::detect_spatio_temporal_features()` takes it by value, for which it has to be move-constructible.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Default_visitor}
\cgalHasModelsEnd
*/
class DetectionVisitor
{
public:
  /// is called when a stage begins. Stages are not nested. Each of them begins once, but for `SCALE_SPACE` and
  /// `EXTREMA`: these alternate, once for each batch of space levels, and `SCALE_SPACE` begins once more at first,
  /// while the spatial filter is prepared. What is known from an earlier call does not begin at all.
  void begin(CGAL::Animated_mesh_features::Stage stage);

  /*!
  is called between a `begin()` and an `end()` of the stage, before each portion of the work and after the last one: at
  least 30 times a stage, less often on meshes of less than 2000 vertices or with policies of the user's own that do not
  use their loops; where that would leave more than a tenth of a second in between, it is called then, too.

  \param stage which began last.
  \param fraction of the whole stage that is done; from 0 to 1 and never less than before.
  \returns whether to go on. If `false`, `CGAL::Animated_mesh_features::Cancelled` is thrown out of the detector before
    any other portion of work. Nothing has been written then; stages that were complete are kept, and the detector can
    be used again.
  */
  bool progress(CGAL::Animated_mesh_features::Stage stage, double fraction);

  /// is called when a stage ends, also if it ends by an exception; must not throw.
  void end(CGAL::Animated_mesh_features::Stage stage);
};
