// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_EXTREMUM_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_EXTREMUM_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// An extremum on the grid of samples, with what is needed to place it between them.
struct Extremum
{
  Rest_shape::Index vertex;
  std::size_t frame, k, l;
  // responses at the vertex, [dk + 1][dl + 1][df + 1]
  std::array<std::array<std::array<double, 3>, 3>, 3> window;
  // responses at the neighbours, in the order of Rest_shape::neighbours(), same scale and frame
  std::vector<double> ring;

  double response() const { return window[1][1][1]; }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_EXTREMUM_H
