// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_SOURCE_PACK_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_SOURCE_PACK_H

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Numbers of several sources, which the same code computes in vector registers: of fixed size, so that every compiler
// does. In double precision, since slivers and the decay of heat would not fit into float.
struct Source_pack
{
  static constexpr std::size_t size = 8;
  typedef Eigen::Array<double, int(size), 1> Array;
  typedef std::vector<Array> Rows; // one for each vertex
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_SOURCE_PACK_H
