// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_FIELD_MEMORY_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_FIELD_MEMORY_H

#ifdef __linux__
  #include <sys/mman.h>
#endif

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesMemory

Where the values of fields live: a memory resource. Fields are nearly all of the memory of a detection, and all of what
grows with vertices times frames. Each field is handed its resource when it is made, by default the heap, and keeps it
alive; what is computed from fields (strain, curvature, levels of the scale space, copies) lives where these do. So it is
enough to read or make an animation in a resource for everything else to follow.

A resource is handed over as an argument, like a `std::pmr::memory_resource`, from which it differs in that its memory
is zero at first - what the system does anyway when large pages are used first - and that fields share its ownership.

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

  /// the resource that fields have by default; it has no state.
  static std::shared_ptr<Field_memory> heap();

private:
  // Large blocks of calloc() are pages that the system clears when they are used first, by the thread that does.
  class Heap;
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

inline std::shared_ptr<Field_memory> Field_memory::heap()
{
  static const std::shared_ptr<Field_memory> memory = std::make_shared<Heap>();
  return memory;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_FIELD_MEMORY_H
