// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_BOUNDARY_EXTENSION_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_BOUNDARY_EXTENSION_H

#include <CGAL/Animated_mesh_features/Scale_space/Boundary_condition.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The values that a row has before its first frame and after its last one.
class Boundary_extension
{
public:
  Boundary_extension() = default;

  // For frames up to `margin` away from the row.
  Boundary_extension(std::size_t number_of_frames, std::size_t margin, Boundary_condition ends)
    : m_frames(number_of_frames)
    , m_margin(margin)
    , m_sources(number_of_frames + 2 * margin)
  {
    for (std::size_t i = 0; i < m_sources.size(); ++i)
      m_sources[i] = source(std::ptrdiff_t(i) - std::ptrdiff_t(margin), ends);
  }

  std::size_t number_of_frames() const { return m_frames; }

  // A pointer to the frame that has the value of frame f, followed by those of f + 1, ...; number_of_frames() for none.
  const std::size_t* sources(std::ptrdiff_t f) const { return m_sources.data() + (f + std::ptrdiff_t(m_margin)); }

  template <class T>
  T value(const T* row, std::ptrdiff_t f) const
  {
    const std::size_t s = *sources(f);
    return s < m_frames ? row[s] : row[0] * typename Scalar_of<T>::type(0);
  }

private:
  std::size_t source(std::ptrdiff_t f, Boundary_condition ends) const
  {
    const std::ptrdiff_t n = std::ptrdiff_t(m_frames);
    if (f < 0 || f >= n) {
      if (ends == Boundary_condition::TRUNCATE) return m_frames;
      if (ends == Boundary_condition::REPLICATE) return f < 0 ? 0 : m_frames - 1;
      if (ends == Boundary_condition::PERIODIC) return std::size_t((f % n + n) % n);
    }
    while (f < 0 || f >= n) f = f < 0 ? -1 - f : 2 * n - 1 - f; // more than once where the box is wider than the row
    return std::size_t(f);
  }

  std::size_t m_frames = 0, m_margin = 0;
  std::vector<std::size_t> m_sources; // of frames [-m_margin, m_frames + m_margin)
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_BOUNDARY_EXTENSION_H
