// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_TEST_TBB_THREADS_H
#define ANIMATED_MESH_FEATURES_TEST_TBB_THREADS_H

namespace tbb {
namespace test {

// At most, and where nothing limits them: more than most test machines have cores, since what matters is that accesses are
// not ordered.
constexpr int number_of_threads = 4;

// What global_control sets.
inline int& allowed_threads()
{
  static int n = number_of_threads;
  return n;
}

// The rank of this thread in the loop that it takes part in; 0 as well outside of all loops.
inline int& rank()
{
  thread_local int r = 0;
  return r;
}

inline bool& in_loop()
{
  thread_local bool b = false;
  return b;
}

} // namespace test
} // namespace tbb

#endif // ANIMATED_MESH_FEATURES_TEST_TBB_THREADS_H
