// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ACTIVITY_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ACTIVITY_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

What `animation_activity()` is told. The defaults suit bodies that are filmed at 8 to 60 frames a second.
*/
struct Activity_options
{
  /// the time between two samples (s), the same for all animations that are compared.
  double sample_duration = 1. / 30;

  /// how many times before and after each sample it is compared with.
  std::size_t lags = 7;

  /// between these (s); a multiple of `sample_duration`, to which it is rounded.
  double lag_step = 1. / 15;

  /// no more samples than that: the time and memory of an alignment grow with the product of both numbers.
  std::size_t max_samples = 20000;

  /// whether the last frame is followed by the first, as in a loop, which is one period long.
  bool is_cyclic = false;

  /// looks whether all numbers are in their ranges.
  /// \throw Option_error if one is not.
  void check() const
  {
    if (!(sample_duration > 0) || !(lag_step > 0)) throw Option_error("the times of an activity must be positive");
    if (lags == 0) throw Option_error("an activity needs at least one lag");
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

Whether a motion repeats itself.
*/
struct Cycle
{
  double period = 0;   ///< seconds; 0 without one
  double strength = 0; ///< from 0, no cycle, to 1, the same again exactly
};

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

How much of a body deforms when, as a sequence of short vectors, which do not depend on frame rate, mesh, size and
correspondence: what animations are aligned and compared by. Each group of numbers has a root mean square of 1 over the
sequence, so that bodies of other flesh or another measure of deformation can be compared.

- `mean`: the mean deformation of the surface.
- `recurrence`: how different the body is deformed some time before and after, \f$\|d(t) - d(t \pm l)\|\f$, the
  neighbourhood of the diagonal of the motion's self-similarity matrix, which depends on the motion more than on the
  body (Junejo, Dexter, Laptev and Perez \cgalCite{junejo2011}).
- `places`: the deformation by how far out on the body it is, in six overlapping classes of the mean distance to all of
  the surface, see `Surface_landmarks`; none if there is no mesh.
*/
struct Activity
{
  std::size_t samples = 0;    ///< `T`
  double sample_duration = 0; ///< seconds
  double level = 0;           ///< the root mean square of the mean deformation, before it was made 1
  std::size_t lags = 0;       ///< `L`
  std::size_t classes = 0;    ///< `P`, 6 or 0

  std::vector<float> mean;       ///< `T`
  std::vector<float> recurrence; ///< `T x 2 L`: later, then earlier, by ascending lags
  std::vector<float> places;     ///< `T x P`

  bool is_cyclic = false; ///< a loop: the last sample is followed by the first

  Cycle cycle; ///< of the whole motion; a loop repeats itself at least after all of its samples

  /// how far the body moves, see `pose_variation()`, which takes positions; none if only a field is known.
  std::optional<double> pose_variation;

  /// from the first to the last sample, of a loop to the first again (s).
  double duration() const
  {
    const std::size_t steps = is_cyclic || samples == 0 ? samples : samples - 1;
    return double(steps) * sample_duration;
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ACTIVITY_H
