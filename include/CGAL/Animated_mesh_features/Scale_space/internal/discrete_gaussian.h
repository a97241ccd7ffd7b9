// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_DISCRETE_GAUSSIAN_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_DISCRETE_GAUSSIAN_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// The right half of the discrete Gaussian of variance u on all integers, e^-u I_m(u) (Lindeberg 1990), up to where
// it vanishes beside its sum. By Miller's backward recurrence I_(m-1) = I_(m+1) + (2 m / u) I_m, which is stable for the
// modified Bessel functions, and e^-u (I_0 + 2 I_1 + 2 I_2 + ...) = 1 (Abramowitz and Stegun, 9.6.26 and 9.6.37): linear in
// the number of weights, where a sum over frequencies is quadratic.
inline std::vector<double> discrete_gaussian(double u)
{
  constexpr double vanishing = 1e-18;
  if (!(u > 0)) return {1};
  std::size_t n = 0; // weights from the n-th on vanish
  if (u < 1) {
    // I_m(u) / I_0(u) is at most (u / 2)^m / m!
    for (double bound = 1; bound > vanishing; bound *= u / 2 / double(++n)) {}
  } else {
    // e^-(m^2 / (2 u)) but for far tails of narrow ones, which are longer
    n = std::size_t(std::ceil(9.2 * std::sqrt(u))) + 16;
  }
  std::vector<double> weights(n + 2, 0);
  weights[n] = 1e-280; // they grow by less than 1 / `vanishing` to the power of some
  for (std::size_t m = n; m > 0; --m) weights[m - 1] = weights[m + 1] + 2 * double(m) / u * weights[m];
  double sum = 0; // the small ones first
  for (std::size_t m = n; m > 0; --m) sum += 2 * weights[m];
  sum += weights[0];
  for (double& w : weights) w /= sum;
  while (weights.size() > 1 && weights.back() < vanishing) weights.pop_back();
  return weights;
}

// The same on a circle of that many integers: weights that reach further around meet.
inline std::vector<double> on_circle(const std::vector<double>& weights, std::size_t circle)
{
  if (weights.size() <= (circle + 1) / 2) return weights;
  std::vector<double> result(circle / 2 + 1, 0);
  for (std::size_t m = weights.size(); m-- > 0;) {
    const std::size_t around = m % circle, i = (std::min)(around, circle - around);
    // a weight stands for both sides, which meet at the start and, if there is such an integer, opposite of it
    result[i] += (i == 0 || 2 * i == circle) && m > 0 ? 2 * weights[m] : weights[m];
  }
  return result;
}

} // namespace internal

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_DISCRETE_GAUSSIAN_H
