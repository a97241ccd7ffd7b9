// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_TEST_TBB_BLOCKED_RANGE_H
#define ANIMATED_MESH_FEATURES_TEST_TBB_BLOCKED_RANGE_H

#include <cstddef>

// ThreadSanitizer cannot see how a TBB that was compiled without it synchronises: it takes every correct program for a
// race, and what silences that silences real races too. Tests under ThreadSanitizer therefore run what they need of TBB
// on plain threads. These headers are found before TBB's.

namespace tbb {

template <class Value>
class blocked_range
{
public:
  blocked_range(Value first, Value last, std::size_t grain_size = 1)
    : m_first(first)
    , m_last(last)
    , m_grain_size(grain_size)
  {}

  Value begin() const { return m_first; }
  Value end() const { return m_last; }
  bool empty() const { return !(m_first < m_last); }
  std::size_t grainsize() const { return m_grain_size; }

private:
  Value m_first, m_last;
  std::size_t m_grain_size;
};

} // namespace tbb

#endif // ANIMATED_MESH_FEATURES_TEST_TBB_BLOCKED_RANGE_H
