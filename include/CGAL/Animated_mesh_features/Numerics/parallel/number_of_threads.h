// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_NUMBER_OF_THREADS_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_NUMBER_OF_THREADS_H

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/global_control.h>
#endif

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// On how many threads parallel loops run at most, now: as many as oneTBB is allowed, 1 without it.
inline std::size_t number_of_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
#else
  return 1;
#endif
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_NUMBER_OF_THREADS_H
