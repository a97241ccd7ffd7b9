// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_CLASSICAL_SCALING_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_CLASSICAL_SCALING_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

places things in the plane so that their distances are as given, as nearly as can be: classical scaling (Torgerson
\cgalCite{torgerson1952}), by the two largest eigenvalues of the doubly centred matrix of squared distances. The sign of
an axis is such that its largest coordinate is positive.

`O(200 n^2)` time, `O(n^2)` memory.

\param distances `n x n`, row by row, symmetric.
\param n how many things.
\returns a place for each.
\throw Option_error if there are not `n x n` distances.
*/
inline std::vector<std::array<double, 2>> classical_scaling(const std::vector<double>& distances, std::size_t n)
{
  if (distances.size() != n * n)
    throw Option_error("there are " + std::to_string(distances.size()) + " distances of " + std::to_string(n) +
                       " things");
  std::vector<double> gram(n * n), means(n, 0);
  double mean = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      means[i] += distances[i * n + j] * distances[i * n + j] / double(n);
      mean += distances[i * n + j] * distances[i * n + j] / double(n) / double(n);
    }
  double trace = 0; // at least the largest eigenvalue's size once it is shifted
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      gram[i * n + j] = -(distances[i * n + j] * distances[i * n + j] - means[i] - means[j] + mean) / 2;
      if (i == j) trace += std::abs(gram[i * n + j]);
    }
  std::vector<std::array<double, 2>> places(n, {{0, 0}});
  for (std::size_t axis = 0; axis < 2; ++axis) {
    // Power iteration; the shift makes the most positive eigenvalue the largest one of all.
    const double shift = trace / double(n > 0 ? n : 1);
    std::vector<double> x(n), next(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = std::cos(double(i + 1) * (1.7 + double(axis)));
    double value = 0;
    for (int k = 0; k < 200; ++k) {
      double squares = 0;
      for (std::size_t i = 0; i < n; ++i) {
        double sum = shift * x[i];
        for (std::size_t j = 0; j < n; ++j) sum += gram[i * n + j] * x[j];
        next[i] = sum;
        squares += sum * sum;
      }
      if (!(squares > 0)) break;
      value = std::sqrt(squares);
      for (std::size_t i = 0; i < n; ++i) x[i] = next[i] / value;
    }
    value -= shift;
    if (!(value > 1e-12 * trace)) break;
    std::size_t largest = 0;
    for (std::size_t i = 1; i < n; ++i)
      if (std::abs(x[i]) > std::abs(x[largest]) * (1 + 1e-9)) largest = i;
    const double sign = x[largest] < 0 ? -1 : 1;
    for (std::size_t i = 0; i < n; ++i) places[i][axis] = sign * std::sqrt(value) * x[i];
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) gram[i * n + j] -= value * x[i] * x[j];
  }
  return places;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_CLASSICAL_SCALING_H
