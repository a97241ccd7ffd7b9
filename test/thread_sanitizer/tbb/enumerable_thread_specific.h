// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_TEST_TBB_ENUMERABLE_THREAD_SPECIFIC_H
#define ANIMATED_MESH_FEATURES_TEST_TBB_ENUMERABLE_THREAD_SPECIFIC_H

#include "threads.h"

#include <array>
#include <cstddef>

namespace tbb {

// One value for each thread of a loop, without a lock, which would order what the threads do. For one loop at a time.
template <class T>
class enumerable_thread_specific
{
public:
  T& local() { return m_values[std::size_t(test::rank())]; }

private:
  std::array<T, test::number_of_threads> m_values{};
};

} // namespace tbb

#endif // ANIMATED_MESH_FEATURES_TEST_TBB_ENUMERABLE_THREAD_SPECIFIC_H
