// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_RUN_IN_CHUNKS_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_RUN_IN_CHUNKS_H

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// task(first, last) for chunks of [0, n), so that vector loops are entered seldom enough for that to cost nothing.
template <class Loop, class Task>
void run_in_chunks(std::size_t n, const Loop& loop, const Task& task)
{
  constexpr std::size_t chunk = 256;
  loop((n + chunk - 1) / chunk, [&](std::size_t i) { task(i * chunk, (std::min)(n, (i + 1) * chunk)); });
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_RUN_IN_CHUNKS_H
