// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_SELECTION_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_SELECTION_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

Which minima of the response become features.
*/
struct Feature_selection
{
  /// the least strength, as a fraction of the strongest response found. In [0, 1].
  double relative_threshold = 0.2;

  /// the least strength, absolute. The stricter of the two thresholds decides.
  double absolute_threshold = 0;

  /// whether to drop what lies within max(sigma) on the surface and max(tau) in time of a stronger feature, if sigma
  /// and tau of the two are each within a factor of 1.5.
  bool suppress_non_maxima = true;

  /// whether features may lie on the border of the mesh, where the smoothing knows only one side.
  bool accept_border_vertices = true;

  /// checks that the thresholds make sense.
  /// \throw Option_error if a threshold is out of its range.
  void check() const
  {
    if (!(relative_threshold >= 0 && relative_threshold <= 1))
      throw Option_error("the relative threshold must be between 0 and 1");
    if (!(absolute_threshold >= 0)) throw Option_error("the absolute threshold must not be negative");
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_SELECTION_H
