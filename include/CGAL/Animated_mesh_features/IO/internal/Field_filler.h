// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FIELD_FILLER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FIELD_FILLER_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Animation/Frame_batch.h>
#include <CGAL/Animated_mesh_features/Numerics/all_finite.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

template <class FT>
void resize_fields(std::size_t number_of_vertices, std::size_t number_of_frames,
                   const std::array<Spatio_temporal_field<FT>*, 3>& fields, const std::shared_ptr<Field_memory>& memory)
{
  for (Spatio_temporal_field<FT>* field : fields)
    *field = Spatio_temporal_field<FT>(number_of_vertices, number_of_frames, memory);
}

// Fills fields from frames in files: a frame is checked as it comes.
template <class FT, class ConcurrencyTag>
class Field_filler
{
  typedef Frame_batch<FT, ConcurrencyTag> Batch;

public:
  // What is in memory beside the fields, and how many frames of a batch can be read at the same time.
  static constexpr std::size_t frames_at_once = 16;

  // `fields`: x, y and z, which have their size
  explicit Field_filler(const typename Batch::Fields& fields)
    : m_batch(fields, frames_at_once)
  {}

  // Frame `f` of the present batch; from any thread. `name` is where it comes from, for messages.
  template <class Number>
  void put(std::size_t f, const Number* xyz, const std::string& name)
  {
    const std::size_t n = 3 * m_batch.number_of_vertices();
    FT* const frame = m_batch.frame(f);
    std::transform(xyz, xyz + n, frame, [](Number x) { return static_cast<FT>(x); });
    if (Animated_mesh_features::internal::all_finite(frame, n)) return;
    const FT* const bad = std::find_if_not(frame, frame + n, [](FT x) { return is_finite(x); });
    throw Input_error(name + ": vertex " + std::to_string((bad - frame) / 3) +
                      " has a coordinate too large for the precision of the computation");
  }

  std::size_t end_of_batch() const { return m_batch.end(); }
  void finish_batch() { m_batch.finish(); }

private:
  Batch m_batch;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FIELD_FILLER_H
