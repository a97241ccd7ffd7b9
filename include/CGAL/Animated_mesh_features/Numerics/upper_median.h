// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_UPPER_MEDIAN_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_UPPER_MEDIAN_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The median, of an even number of values the larger one of the two in the middle; 0 of none. Reorders them. Linear time.
inline double upper_median(std::vector<double>& values)
{
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_UPPER_MEDIAN_H
