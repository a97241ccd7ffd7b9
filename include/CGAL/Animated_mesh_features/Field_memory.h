// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_FIELD_MEMORY_H
#define CGAL_ANIMATED_MESH_FEATURES_FIELD_MEMORY_H

#ifdef __linux__
  #include <sys/mman.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <new>
#include <utility>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesMemory

Where the values of fields live. Fields are nearly all of the memory of a detection, and all of what grows with vertices
times frames; they take theirs from the memory that is current when they are made: the heap, unless a
`Field_memory_scope` says otherwise.

\sa `Scratch_field_memory`
*/
class Field_memory
{
public:
  virtual ~Field_memory() = default;

  /// returns `bytes` zero bytes, aligned to 64. Called from any thread.
  /// \throw std::bad_alloc, or an `Error` that says more.
  virtual void* allocate(std::size_t bytes) = 0;

  /// takes back what `allocate()` returned for as many bytes. Called from any thread.
  virtual void deallocate(void* values, std::size_t bytes) noexcept = 0;

  /// the memory that fields are taken from.
  static std::shared_ptr<Field_memory> current()
  {
    const std::lock_guard<std::mutex> lock(mutex());
    return instance();
  }

private:
  /// \cond SKIP_IN_MANUAL
  friend class Field_memory_scope;
  /// \endcond

  // Large blocks of calloc() are pages that the system clears when they are used first, by the thread that does.
  class Heap;

  static std::mutex& mutex()
  {
    static std::mutex m;
    return m;
  }
  static std::shared_ptr<Field_memory>& instance();
};

/// \cond SKIP_IN_MANUAL
class Field_memory::Heap : public Field_memory
{
public:
  void* allocate(std::size_t bytes) override
  {
    void* const block = std::calloc(bytes + alignment, 1);
    if (block == nullptr) throw std::bad_alloc();
    // aligned, with the way back in front
    const std::uintptr_t start = (reinterpret_cast<std::uintptr_t>(block) / alignment + 1) * alignment;
    void* const values = reinterpret_cast<void*>(start);
    static_cast<void**>(values)[-1] = block;
#ifdef __linux__
    // Large pages, where there are any: the first touch of a field takes half as long.
    constexpr std::uintptr_t page = std::uintptr_t(1) << 21;
    const std::uintptr_t first = (start + page - 1) / page * page, last = (start + bytes) / page * page;
    if (first < last) ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
    return values;
  }

  void deallocate(void* values, std::size_t) noexcept override
  {
    if (values != nullptr) std::free(static_cast<void**>(values)[-1]);
  }

private:
  static constexpr std::size_t alignment = 64; // calloc() aligns to 16: there is always room for a pointer in front
};
/// \endcond

inline std::shared_ptr<Field_memory>& Field_memory::instance()
{
  static std::shared_ptr<Field_memory> memory = std::make_shared<Heap>();
  return memory;
}

/*!
\ingroup PkgAnimatedMeshFeaturesMemory

Makes a `Field_memory` the current one as long as the scope lives. It concerns all threads. Fields stay where they were
made, and keep their memory alive.
*/
class Field_memory_scope
{
public:
  /// from now on fields take their values from `memory`.
  explicit Field_memory_scope(std::shared_ptr<Field_memory> memory) : m_before(std::move(memory)) { exchange(); }
  ~Field_memory_scope() { exchange(); }
  Field_memory_scope(const Field_memory_scope&) = delete;
  Field_memory_scope& operator=(const Field_memory_scope&) = delete;

private:
  void exchange()
  {
    const std::lock_guard<std::mutex> lock(Field_memory::mutex());
    Field_memory::instance().swap(m_before);
  }

  std::shared_ptr<Field_memory> m_before;
};

namespace internal {

// The values of a field: zeros at first.
template <class FT>
class Field_values
{
public:
  Field_values() = default;

  explicit Field_values(std::size_t size)
    : m_memory(size > 0 ? Field_memory::current() : nullptr)
    , m_size(size)
  {
    if (size > std::size_t(-1) / sizeof(FT) / 2) throw std::bad_alloc();
    if (size > 0) m_values = static_cast<FT*>(m_memory->allocate(size * sizeof(FT)));
  }

  Field_values(const Field_values& other) : Field_values(other.m_size) { copy(other); }
  Field_values(Field_values&& other) noexcept { swap(other); }

  Field_values& operator=(const Field_values& other)
  {
    if (m_size == other.m_size) {
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

#endif // CGAL_ANIMATED_MESH_FEATURES_FIELD_MEMORY_H
