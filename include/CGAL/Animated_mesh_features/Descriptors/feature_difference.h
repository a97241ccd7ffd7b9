// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_FEATURE_DIFFERENCE_H
#define CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_FEATURE_DIFFERENCE_H

#include <CGAL/Animated_mesh_features/Descriptors/Described_features.h>
#include <CGAL/Animated_mesh_features/Descriptors/Matching_options.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

tells how different two features of two animations are by themselves: the root of the sum of squares of what they differ
in, each times its weight. What is not known of both counts nothing. `O(L)` for descriptors of length `L`.

\param a, i the first animation's features, and a rank among them.
\param b, j the same of the second one.
\param o the weights.
*/
inline double feature_difference(const Described_features& a, std::size_t i, const Described_features& b, std::size_t j,
                                 const Matching_options& o)
{
  const Feature_point& f = a.features[i];
  const Feature_point& g = b.features[j];
  double squares = 0;
  const auto add = [&](double x) { squares += x * x; };
  const auto add_ratio = [&](double weight, double x, double y) {
    if (x > 0 && y > 0) add(weight * std::log(x / y));
  };
  add_ratio(o.sigma_weight, f.sigma / a.unit, g.sigma / b.unit);
  add_ratio(o.tau_weight, f.tau, g.tau);
  add_ratio(o.amplitude_weight, f.amplitude, g.amplitude);
  const auto add_distance = [&](double weight, const Feature_descriptors& x, const Feature_descriptors& y) {
    if (i < x.size() && j < y.size() && x.length() == y.length())
      add(weight * descriptor_distance(x[i], y[j], x.length()));
  };
  add_distance(o.descriptor_weight, a.descriptors, b.descriptors);
  add_distance(o.place_weight, a.places, b.places);
  return std::sqrt(squares);
}

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

tells which features are the strongest.
\returns the ranks of the `top` strongest features, strongest first; of equally strong ones the first.
*/
inline std::vector<std::size_t> strongest_features(const std::vector<Feature_point>& features, std::size_t top)
{
  std::vector<std::size_t> order(features.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return features[i].strength > features[j].strength; });
  if (order.size() > top) order.resize(top);
  return order;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_FEATURE_DIFFERENCE_H
