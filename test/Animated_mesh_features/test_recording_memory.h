// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_TEST_RECORDING_MEMORY_H
#define CGAL_ANIMATED_MESH_FEATURES_TEST_RECORDING_MEMORY_H

#include <CGAL/Animated_mesh_features/Numerics/memory/Field_memory.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>

namespace test_support {

// The heap, and a record of what was asked of it.
class Recording_memory : public CGAL::Animated_mesh_features::Field_memory
{
public:
  void* allocate(std::size_t bytes) override
  {
    void* const values = heap()->allocate(bytes);
    const std::lock_guard<std::mutex> lock(m_mutex);
    ++m_allocations[bytes];
    ++m_in_use;
    m_most_in_use = (std::max)(m_most_in_use, m_in_use);
    return values;
  }

  void deallocate(void* values, std::size_t bytes) noexcept override
  {
    heap()->deallocate(values, bytes);
    const std::lock_guard<std::mutex> lock(m_mutex);
    --m_in_use;
  }

  // how many blocks of that size there were
  std::size_t allocations(std::size_t bytes) const
  {
    const auto found = m_allocations.find(bytes);
    return found == m_allocations.end() ? 0 : found->second;
  }

  std::size_t allocations() const
  {
    std::size_t n = 0;
    for (const auto& of_size : m_allocations) n += of_size.second;
    return n;
  }

  std::size_t in_use() const { return m_in_use; }           // blocks now
  std::size_t most_in_use() const { return m_most_in_use; } // blocks at a time
  void forget_most_in_use() { m_most_in_use = m_in_use; }

private:
  std::mutex m_mutex;
  std::map<std::size_t, std::size_t> m_allocations; // by size in bytes
  std::size_t m_in_use = 0, m_most_in_use = 0;
};

} // namespace test_support

#endif // CGAL_ANIMATED_MESH_FEATURES_TEST_RECORDING_MEMORY_H
