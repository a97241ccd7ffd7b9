// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_FEATURE_NEIGHBOURHOOD_H
#define CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_FEATURE_NEIGHBOURHOOD_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

What a feature descriptor sees of a feature: samples of the field around it, in coordinates of the feature's own.

Places are those of a log map of the rest shape: a plane that touches the surface at the feature, divided by
\f$\sigma\f$; times are counted from that of the feature and divided by \f$\tau\f$. The direction of the first axis is
arbitrary, the second one is a quarter turn counterclockwise from it, seen from outside. `V` places, `T` times.
*/
struct Feature_neighbourhood
{
  /// A place of the neighbourhood.
  struct Place
  {
    double x = 0;    ///< \f$\sigma\f$
    double y = 0;    ///< \f$\sigma\f$
    double area = 0; ///< its share of the surface, \f$\sigma^2\f$
  };

  /// The derivatives of the field along both axes of the log map and along time, in units of the field for one
  /// \f$\sigma\f$, \f$\sigma\f$ and \f$\tau\f$.
  typedef std::array<float, 3> Gradient;

  std::vector<Place> places;       ///< `V`
  std::vector<double> times;       ///< `T`, ascending, equidistant (\f$\tau\f$)
  std::vector<float> values;       ///< `V x T` values of the field, those of a place next to one another
  std::vector<Gradient> gradients; ///< `V x T`, in the same order

  /// how far it reaches: \f$\sigma\f$ on the surface, \f$\tau\f$ in time.
  static constexpr double reach = 3;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_FEATURE_NEIGHBOURHOOD_H
