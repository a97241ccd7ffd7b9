// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_ALIGNED_VECTOR_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_ALIGNED_VECTOR_H

#include <boost/align/aligned_allocator.hpp>

#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Numbers that start at a cache line.
template <class T>
using Aligned_vector = std::vector<T, boost::alignment::aligned_allocator<T, 64>>;

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_ALIGNED_VECTOR_H
