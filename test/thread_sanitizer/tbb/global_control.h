// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_TEST_TBB_GLOBAL_CONTROL_H
#define ANIMATED_MESH_FEATURES_TEST_TBB_GLOBAL_CONTROL_H

#include "threads.h"

#include <algorithm>
#include <cstddef>

namespace tbb {

// Limits the threads of the loops as long as it lives. Made and destroyed by one thread, outside of all loops.
class global_control
{
public:
  enum parameter { max_allowed_parallelism };

  global_control(parameter, std::size_t value)
    : m_before(test::allowed_threads())
  {
    test::allowed_threads() = (std::min)(m_before, int(value));
  }
  static std::size_t active_value(parameter) { return std::size_t(test::allowed_threads()); }

  ~global_control() { test::allowed_threads() = m_before; }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;

private:
  int m_before;
};

} // namespace tbb

#endif // ANIMATED_MESH_FEATURES_TEST_TBB_GLOBAL_CONTROL_H
