// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_WINDOW_SUMS_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_WINDOW_SUMS_H

#include <CGAL/Animated_mesh_features/Scale_space/internal/Boundary_extension.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// emit(i, sum i - 1, sum i) for each i < count in ascending order, where sum i is that of the `width` frames from
// first + i on; emit_first instead for i = 0, which has no sum before it, and every multiple of the width. The extension
// reaches two widths beyond the row.
//
// Three additions a sum, whatever the width, and nothing is ever subtracted, so that a sum has the rounding errors of
// its own terms only (van Herk, Gil and Werman's scheme for minima): the row is cut into blocks of the width, and a
// window is the rest of one block (sums from the right) and the beginning of the next (from the left).
template <class T, class Emit_first, class Emit>
void window_sums(const Boundary_extension& extension, const T* in, std::ptrdiff_t first, std::ptrdiff_t count,
                 std::ptrdiff_t width, const Emit_first& emit_first, const Emit& emit)
{
  // the rests, and two blocks that reach beyond the row
  static thread_local std::vector<T> buffer;
  if (std::ptrdiff_t(buffer.size()) < 3 * width) buffer.resize(std::size_t(3 * width));
  T* const rests = buffer.data();
  T *copy = rests + width, *other_copy = copy + width;
  const auto block = [&](std::ptrdiff_t start) -> const T* {
    const std::ptrdiff_t f = first + start;
    if (f >= 0 && f + width <= std::ptrdiff_t(extension.number_of_frames())) return in + f;
    std::swap(copy, other_copy);
    for (std::ptrdiff_t i = 0; i < width; ++i) copy[i] = extension.value(in, f + i);
    return copy;
  };
  const T* now = block(0);
  T before = now[0]; // a variable of its own in each loop, so that it stays in registers
  for (std::ptrdiff_t start = 0; start < count; start += width) {
    T rest = now[width - 1];
    rests[width - 1] = rest;
    for (std::ptrdiff_t i = width - 2; i >= 0; --i) {
      rest = rest + now[i];
      rests[i] = rest;
    }
    emit_first(start, before, rest);
    before = rest;
    const std::ptrdiff_t end = (std::min)(width, count - start);
    if (start + 1 >= count) break;
    now = block(start + width);
    if (end < 2) continue;
    T beginning = now[0], last = rests[1] + beginning;
    emit(start + 1, before, last);
    for (std::ptrdiff_t i = 2; i < end; ++i) {
      beginning = beginning + now[i - 1];
      const T sum = rests[i] + beginning;
      emit(start + i, last, sum);
      last = sum;
    }
    before = last;
  }
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_WINDOW_SUMS_H
