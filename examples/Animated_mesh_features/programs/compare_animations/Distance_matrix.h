// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_ANIMATIONS_DISTANCE_MATRIX_H
#define COMPARE_ANIMATIONS_DISTANCE_MATRIX_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace Compare_animations {

// The distances of all pairs of a collection, and places in the plane that have about these distances.
struct Distance_matrix
{
  std::vector<std::string> names;
  std::vector<double> distances; // row by row
  std::vector<std::array<double, 2>> places;

  std::size_t size() const { return names.size(); }
  double operator()(std::size_t i, std::size_t j) const { return distances[i * names.size() + j]; }
};

} // namespace Compare_animations

#endif // COMPARE_ANIMATIONS_DISTANCE_MATRIX_H
