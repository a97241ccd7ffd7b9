// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_SPATIO_TEMPORAL_FIELD_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_SPATIO_TEMPORAL_FIELD_H

#include <CGAL/Animated_mesh_features/Numerics/memory/Field_memory.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Field_values.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

An `N x F` array of scalars: a value for each of `N` simplices (vertices, sometimes faces) and each of `F` frames.

The frames of a simplex are contiguous, so that whatever acts on the surface (averages over neighbours, sums over
geodesic balls) is a combination of rows and runs over the frames in vector registers. Rows start at multiples of
64 bytes; the padding after a row's last frame is part of the array, is zero at first, and may be overwritten.

Row `i` belongs to the `i`-th element of `vertices(mesh)` (or of `faces(mesh)`). The values live in a
`Field_memory`, which a field shares with its copies and with what is computed from it.

\tparam FT_ `float` or `double`.
*/
template <class FT_>
class Spatio_temporal_field
{
public:
  /// the scalar type
  typedef FT_ FT;

  /// an empty field, 0 x 0.
  Spatio_temporal_field() = default;

  /// a field of `number_of_rows x number_of_frames` zeros.
  /// \param number_of_rows, number_of_frames `N` and `F`.
  /// \param memory where the values live.
  /// \throw std::bad_alloc, or what `memory` throws.
  Spatio_temporal_field(std::size_t number_of_rows, std::size_t number_of_frames,
                        std::shared_ptr<Field_memory> memory = Field_memory::heap())
    : m_rows(number_of_rows)
    , m_frames(number_of_frames)
    , m_stride(padded(number_of_frames))
    , m_values(number_of_rows * m_stride, std::move(memory))
  {
  }

  std::size_t number_of_rows() const { return m_rows; }     ///< `N`
  std::size_t number_of_frames() const { return m_frames; } ///< `F`

  /// the distance between the starts of two rows, in scalars; at least `number_of_frames()`, a multiple of 64 bytes.
  std::size_t stride() const { return m_stride; }

  /// the value of a simplex in a frame, both from 0.
  FT& operator()(std::size_t row, std::size_t frame) { return m_values[row * m_stride + frame]; }
  /// the value of a simplex in a frame, both from 0.
  const FT& operator()(std::size_t row, std::size_t frame) const { return m_values[row * m_stride + frame]; }

  /// the first of the `number_of_frames()` values of a row.
  FT* row(std::size_t i) { return m_values.data() + i * m_stride; }

  /// the first of the `number_of_frames()` values of a row.
  const FT* row(std::size_t i) const { return m_values.data() + i * m_stride; }

  /// where the values live; null for a field that was made empty.
  const std::shared_ptr<Field_memory>& memory() const { return m_values.memory(); }

  /// the memory that the values take, in bytes.
  std::size_t size_in_bytes() const { return m_values.size() * sizeof(FT); }

  /// that of a field before there is one.
  static std::size_t size_in_bytes(std::size_t number_of_rows, std::size_t number_of_frames)
  {
    return number_of_rows * padded(number_of_frames) * sizeof(FT);
  }

  /// exchanges the values of two fields, of whatever shapes, in constant time.
  void swap(Spatio_temporal_field& other)
  {
    std::swap(m_rows, other.m_rows);
    std::swap(m_frames, other.m_frames);
    std::swap(m_stride, other.m_stride);
    m_values.swap(other.m_values);
  }

private:
  // Whole cache lines a row; never a multiple of 4 KiB between rows, which would map the same column of neighbouring
  // rows to the same set of the L1 cache.
  static std::size_t padded(std::size_t frames)
  {
    const std::size_t line = 64 / sizeof(FT);
    const std::size_t lines = (std::max)(std::size_t(1), (frames + line - 1) / line);
    return (lines % 64 == 0 ? lines + 1 : lines) * line;
  }

  std::size_t m_rows = 0;
  std::size_t m_frames = 0;
  std::size_t m_stride = 0;
  internal::Field_values<FT> m_values;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_SPATIO_TEMPORAL_FIELD_H
