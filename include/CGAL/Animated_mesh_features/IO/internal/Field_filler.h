// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FIELD_FILLER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FIELD_FILLER_H

#include <CGAL/Animated_mesh_features/exceptions.h>
#include <CGAL/Animated_mesh_features/internal/parallel_for.h>
#include <CGAL/Animated_mesh_features/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>
#include <CGAL/Animated_mesh_features/IO/internal/transpose_frames.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Gives fields their size; on several threads, as the first touch of that much memory takes longer than to read a cache
// into it.
template <class ConcurrencyTag, class FT>
void resize_fields(std::size_t number_of_vertices, std::size_t number_of_frames,
                   const std::array<Spatio_temporal_field<FT>*, 3>& fields)
{
  Animated_mesh_features::internal::parallel_for<ConcurrencyTag>(0, fields.size(), [&](std::size_t c) {
    Spatio_temporal_field<FT>(number_of_vertices, number_of_frames).swap(*fields[c]);
  });
}

// Turns frames that come vertex by vertex into fields whose rows are vertices. A frame alone would touch a cache line
// of every row for one number; frames are therefore gathered in batches, which are transposed as a whole. The frames of
// a batch may be put in any order, from several threads.
template <class FT, class ConcurrencyTag>
class Field_filler
{
public:
  typedef std::array<Spatio_temporal_field<FT>*, 3> Fields;

  // whole cache lines of rows
  static constexpr std::size_t frames_at_once = 16;

  // `fields`: x, y and z, which have their size
  explicit Field_filler(const Fields& fields)
    : m_vertices(fields[0]->number_of_rows())
    , m_frames(fields[0]->number_of_frames())
    , m_fields(fields)
    , m_gathered(3 * m_vertices * (std::min)(frames_at_once, m_frames))
  {}

  // Frame `f` of the present batch; `name` is where it comes from, for messages.
  template <class Number>
  void put(std::size_t f, const Number* xyz, const std::string& name)
  {
    FT* const frame = m_gathered.data() + (f - m_first) * 3 * m_vertices;
    std::transform(xyz, xyz + 3 * m_vertices, frame, [](Number x) { return static_cast<FT>(x); });
    if (all_finite(frame, 3 * m_vertices)) return;
    const FT* const bad = std::find_if_not(frame, frame + 3 * m_vertices, [](FT x) { return is_finite(x); });
    throw Input_error(name + ": vertex " + std::to_string((bad - frame) / 3) +
                      " has a coordinate too large for the precision of the computation");
  }

  // The end of the present batch of frames; the next one starts there.
  std::size_t end_of_batch() const { return (std::min)(m_first + frames_at_once, m_frames); }

  // To be called when all frames of the batch were put.
  void finish_batch()
  {
    const std::size_t first = m_first, frames = end_of_batch() - first;
    const std::size_t pieces = (m_vertices + vertices_of_piece - 1) / vertices_of_piece;
    Animated_mesh_features::internal::parallel_for<ConcurrencyTag>(0, pieces, [&](std::size_t i) {
      const std::size_t v = i * vertices_of_piece;
      const Frame_piece piece = {v, (std::min)(vertices_of_piece, m_vertices - v), first, frames};
      const auto frame = [&](std::size_t f) { return m_gathered.data() + (f * m_vertices + v) * 3; };
      transpose_frames(piece, frame, m_fields);
    });
    m_first += frames;
  }

private:
  std::size_t m_vertices, m_frames;
  Fields m_fields;
  std::vector<FT> m_gathered; // the frames of the batch, one behind the other
  std::size_t m_first = 0;    // of the batch
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FIELD_FILLER_H
