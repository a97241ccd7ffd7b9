// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_PLACED_FEATURE_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_PLACED_FEATURE_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

Of a feature what is compared with features of another detection: its place on a shape that both have in common, its time
and its scales.
*/
struct Placed_feature
{
  Rest_shape::Point place = Rest_shape::Point::Zero(); ///< on the common shape (length)
  double time = 0;                                     ///< seconds
  double sigma = 0; ///< positive; a length, or a ratio to the size of the body if bodies of two sizes are compared
  double tau = 0;   ///< positive; seconds
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

How far two features may be apart to count as the same. The factor goes with figures that ask for scales, too.
*/
struct Matching_gates
{
  double place = 0;    ///< the largest distance in space (length)
  double time = 0;     ///< the largest distance in time (seconds)
  double factor = 1.5; ///< the largest ratio of two values of sigma, and of tau; at least 1
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

whether two features are at the same place and time.
*/
inline bool are_at_same_place_and_time(const Placed_feature& a, const Placed_feature& b, const Matching_gates& gates)
{
  return std::abs(a.time - b.time) <= gates.time && (a.place - b.place).norm() <= gates.place;
}

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

whether two features are of about the same size and duration.
*/
inline bool have_same_scales(const Placed_feature& a, const Placed_feature& b, const Matching_gates& gates)
{
  const auto is_near = [&](double x, double y) { return (std::max)(x, y) <= gates.factor * (std::min)(x, y); };
  return is_near(a.sigma, b.sigma) && is_near(a.tau, b.tau);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_PLACED_FEATURE_H
