// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ALIGNMENT_OPTIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ALIGNMENT_OPTIONS_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

What `align_animations()` is told. Each weight is that of the squares of a group of numbers, see `Activity`.
*/
struct Alignment_options
{
  double mean_weight = 1; ///< of the mean deformation

  /// whether what is there at all times, be it noise or the difference of the rest shape from all frames, is taken out of
  /// the mean deformation: of its squares the least one. For whole motions: a part of one has another least.
  bool without_least_mean = false;

  double recurrence_weight = 0; ///< of the differences from times before and after, which a warp of time changes, too
  double recurrence_without_places = 3; ///< the same, at least, where nothing is known of places
  double place_weight = 3;              ///< of the deformation by place, if both animations have it

  /// how much faster one of the two may run than the other, for a time.
  std::size_t max_slope = 3;

  /// how much samples count that have no partner because one animation begins or ends before the other: 0 for ends that
  /// cost nothing, 1 for two takes of the whole motion.
  double end_weight = 1;

  /// what it costs that a sample has no partner of its own, in units of the mean length of a sample's vector.
  double bend_weight = 0.02;

  /// how smooth the map is (s): changes of speed within less than that count more than what moves. 0: the way as it is, in
  /// steps of a sample, which is faster.
  double smoothing = 1. / 15;

  /// by how many rearrangements the confidence is found; 0: none, which is faster.
  std::size_t surrogates = 8;

  /// looks whether all numbers are in their ranges.
  /// \throw Option_error if one is not.
  void check() const
  {
    for (double w : {mean_weight, recurrence_weight, recurrence_without_places, place_weight})
      if (!(w >= 0)) throw Option_error("the weights of an alignment must not be negative");
    if (!(mean_weight + recurrence_weight > 0)) throw Option_error("mean and recurrence must not both count nothing");
    if (max_slope < 1 || max_slope > 100) throw Option_error("the slope of an alignment is from 1 to 100");
    if (!(bend_weight >= 0)) throw Option_error("the weight of bends must not be negative");
    if (!(smoothing >= 0)) throw Option_error("the smoothing of an alignment must not be negative");
    if (!(end_weight >= 0 && end_weight <= 1)) throw Option_error("the weight of ends is from 0 to 1");
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ALIGNMENT_OPTIONS_H
