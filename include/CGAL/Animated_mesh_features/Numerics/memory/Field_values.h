// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_FIELD_VALUES_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_FIELD_VALUES_H

#include <CGAL/Animated_mesh_features/Numerics/memory/Field_memory.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The values of a field: zeros at first.
template <class FT>
class Field_values
{
public:
  Field_values() = default;

  Field_values(std::size_t size, std::shared_ptr<Field_memory> memory)
    : m_memory(std::move(memory))
    , m_size(size)
  {
    if (size > std::size_t(-1) / sizeof(FT) / 2) throw std::bad_alloc();
    if (size > 0) m_values = static_cast<FT*>(m_memory->allocate(size * sizeof(FT)));
  }

  Field_values(const Field_values& other) : Field_values(other.m_size, other.m_memory) { copy(other); }
  Field_values(Field_values&& other) noexcept { swap(other); }

  Field_values& operator=(const Field_values& other)
  {
    if (m_size == other.m_size && m_memory == other.m_memory) {
      copy(other);
    } else {
      Field_values values(other);
      swap(values);
    }
    return *this;
  }

  Field_values& operator=(Field_values&& other) noexcept
  {
    Field_values values(std::move(other));
    swap(values);
    return *this;
  }

  ~Field_values()
  {
    if (m_values != nullptr) m_memory->deallocate(m_values, m_size * sizeof(FT));
  }

  void swap(Field_values& other) noexcept
  {
    m_memory.swap(other.m_memory);
    std::swap(m_values, other.m_values);
    std::swap(m_size, other.m_size);
  }

  FT* data() { return m_values; }
  const FT* data() const { return m_values; }
  FT& operator[](std::size_t i) { return m_values[i]; }
  const FT& operator[](std::size_t i) const { return m_values[i]; }
  std::size_t size() const { return m_size; }

  const std::shared_ptr<Field_memory>& memory() const { return m_memory; }

private:
  void copy(const Field_values& other)
  {
    if (m_values != other.m_values) std::copy(other.m_values, other.m_values + m_size, m_values);
  }

  std::shared_ptr<Field_memory> m_memory; // outlives the values
  FT* m_values = nullptr;
  std::size_t m_size = 0;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_FIELD_VALUES_H
