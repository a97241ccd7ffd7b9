// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_STEP_WEIGHTS_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_STEP_WEIGHTS_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// What smooths a row by a step: weights[i] is that of the frames i strides away, on either side; to be applied so many
// times.
struct Step_weights
{
  std::ptrdiff_t stride;
  std::vector<double> weights;
  std::size_t parts;
  std::ptrdiff_t reach() const { return stride * std::ptrdiff_t(weights.size() - 1); }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_STEP_WEIGHTS_H
