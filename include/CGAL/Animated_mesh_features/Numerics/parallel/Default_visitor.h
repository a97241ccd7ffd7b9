// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_DEFAULT_VISITOR_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_DEFAULT_VISITOR_H

#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesTasks

The visitor that does nothing: a model of `DetectionVisitor`, to derive from or to imitate.

All three functions are called from the thread that called the detector, and from no other, so that they may print,
draw or look at a user interface without locking.

\cgalModels{DetectionVisitor}
*/
struct Default_visitor
{
  /// called when a stage begins. `SCALE_SPACE` begins a first time while its filter is prepared; then `SCALE_SPACE` and
  /// `EXTREMA` begin and end alternately, once for each batch of space levels, and their fractions go on growing. The
  /// other stages begin once.
  void begin(Stage) {}

  /*!
  called between tasks of a stage that this thread works on, some 30 times a stage (on small meshes less often), with
  `fraction` growing from 0 to 1.
  Stages of which a part cannot be divided (a factorisation) are silent for that time.
  \returns whether to go on. If `false`, no further tasks begin, and `Cancelled` is thrown out of the detector.
  */
  bool progress(Stage, double /* fraction */) { return true; }

  /// called when a stage ends, also if it ends by an exception.
  void end(Stage) {}
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_DEFAULT_VISITOR_H
