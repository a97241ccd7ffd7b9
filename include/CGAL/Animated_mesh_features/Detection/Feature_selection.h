// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_SELECTION_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_SELECTION_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

Which minima of the response become features.

The defaults are those of a deformation, whose unit is known: strain and change of curvature are numbers without unit. For
a field of another unit see `of_any_field()`.
*/
struct Feature_selection
{
  /// the least strength, in the unit of the field. By default 0.1, above which three features in four are at a
  /// joint that moves, measured on bodies with skeletons. It does not depend on what else happens in the clip.
  double absolute_threshold = 0.1;

  /// the least strength, as a fraction of the strongest one found, in [0, 1]; by default there is none. The stricter of the
  /// two thresholds decides. A single burst hides everything else by it.
  double relative_threshold = 0;

  /// the least fit, see `Feature_point::fit`; 0 or less: any. By default 0.5: of what is below, one in ten is at a joint
  /// that moves, measured on bodies with skeletons; of what is above, more than four in ten.
  double min_fit = 0.5;

  /// that many features at most, the strongest ones.
  std::size_t most_features = std::size_t(-1);

  /// whether to drop what lies within max(sigma) on the surface and max(tau) in time of a stronger feature, if sigma
  /// and tau of the two are each within a factor of 1.5; and, whatever the scales, what overlaps an event of larger norm,
  /// if what is then left of its strength is below the threshold: \f$(1 - \rho)^{1.5 / r}\f$ of it, where \f$\rho\f$ is the
  /// cosine between the two Gaussians and \f$r\f$ the ratio of their norms, strength times \f$\sqrt{\sigma\tau}\f$, at
  /// least 0.2; soft non-maximum suppression \cgalCite{bodla2017}. In a cyclic animation times differ by the shorter way
  /// round. Reported strengths stay what they are.
  bool suppress_non_maxima = true;

  /// whether features may lie on the border of the mesh, where the smoothing knows only one side.
  bool accept_border_vertices = true;

  /// the selection for fields of any unit: at least a fifth of the strongest.
  static Feature_selection of_any_field()
  {
    Feature_selection selection;
    selection.absolute_threshold = 0;
    selection.relative_threshold = 0.2;
    return selection;
  }

  /// the stricter of both thresholds, if `strongest` is the largest strength.
  double least_strength(double strongest) const
  {
    return (std::max)(absolute_threshold, relative_threshold * strongest);
  }

  /// checks that the thresholds make sense.
  /// \throw Option_error if a threshold or the least fit is out of its range.
  void check() const
  {
    if (!(relative_threshold >= 0 && relative_threshold <= 1))
      throw Option_error("the relative threshold must be between 0 and 1");
    if (!(absolute_threshold >= 0)) throw Option_error("the absolute threshold must not be negative");
    if (!(min_fit <= 1)) throw Option_error("the least fit must be at most 1");
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_SELECTION_H
