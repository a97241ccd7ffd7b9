// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_MATCHING_OPTIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_MATCHING_OPTIONS_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

Two features that show the same event.
*/
struct Feature_match
{
  std::size_t a = 0;     ///< the rank of the feature in the first animation
  std::size_t b = 0;     ///< that in the second one
  double confidence = 0; ///< from 0 to 1: how well the pair agrees with the others, less for few pairs
  double difference = 0; ///< how different the two features are by themselves, 0 for the same
};

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

What `match_features()` is told. The difference of two features is the root of the sum of squares of what they differ
in, each times its weight.
*/
struct Matching_options
{
  std::size_t top = 150;      ///< how many of the strongest features of either animation are matched
  std::size_t candidates = 8; ///< for each of them

  double descriptor_weight = 1; ///< of the distance of descriptors
  double place_weight = 4;   ///< of the distance of profiles, see `Surface_landmarks`
  double sigma_weight = 0.5; ///< of the logarithm of the ratio of \f$\sigma\f$
  double tau_weight = 0.5;   ///< of the logarithm of the ratio of \f$\tau\f$
  double amplitude_weight = 0.3; ///< of the logarithm of the ratio of amplitudes

  /// only candidates of which each is the other's nearest; off, as the cycles of a gait are alike.
  bool mutual_nearest = false;

  /// only candidates whose difference is less than this times that of the second nearest; 1: all. A cycle fails it.
  double max_ratio = 1;

  double distance_tolerance = 0.1; ///< of distances on the surface, in units of the body
  double time_tolerance = 0.3;     ///< of times, as a share of the larger one; a warp of time is tolerated that far

  /// whether mirror images are told apart by places on the rest shapes.
  bool use_handedness = true;

  /// looks whether all numbers are in their ranges.
  /// \throw Option_error if one is not.
  void check() const
  {
    if (candidates == 0) throw Option_error("a feature needs at least one candidate");
    for (double w : {descriptor_weight, place_weight, sigma_weight, tau_weight, amplitude_weight})
      if (!(w >= 0)) throw Option_error("the weights of a matching must not be negative");
    if (!(max_ratio > 0 && max_ratio <= 1)) throw Option_error("the largest ratio is above 0 and at most 1");
    if (!(distance_tolerance > 0) || !(time_tolerance > 0)) throw Option_error("tolerances must be positive");
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_MATCHING_OPTIONS_H
