// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FIELD_FILLER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FIELD_FILLER_H

#include <CGAL/Animated_mesh_features/exceptions.h>
#include <CGAL/Animated_mesh_features/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Turns frames that come one by one, vertex by vertex, into fields whose rows are vertices. A frame alone would touch a
// cache line of every row for one number; frames are therefore gathered until they fill the line.
template <class FT>
class Field_filler
{
public:
  typedef Spatio_temporal_field<FT> Field;

  Field_filler(std::size_t number_of_vertices, std::size_t number_of_frames, Field& x, Field& y, Field& z)
    : m_vertices(number_of_vertices)
    , m_fields{{&x, &y, &z}}
    , m_gathered((std::min)(frames_at_once, number_of_frames) * 3 * number_of_vertices)
  {
    for (Field* field : m_fields) *field = Field(number_of_vertices, number_of_frames);
  }

  // The next frame; `name` is where it comes from, for messages.
  template <class Number>
  void add(const Number* xyz, const std::string& name)
  {
    FT* const frame = m_gathered.data() + m_number_gathered * 3 * m_vertices;
    bool fits = true;
    for (std::size_t i = 0; i < 3 * m_vertices; ++i) {
      frame[i] = static_cast<FT>(xyz[i]);
      fits = fits && is_finite(frame[i]);
    }
    for (std::size_t i = 0; !fits && i < 3 * m_vertices; ++i)
      if (!is_finite(frame[i]))
        throw Input_error(name + ": vertex " + std::to_string(i / 3) +
                          " has a coordinate too large for the precision of the computation");
    ++m_number_gathered;
    if (m_number_gathered == frames_at_once || m_first + m_number_gathered == m_fields[0]->number_of_frames()) flush();
  }

private:
  static constexpr std::size_t frames_at_once = 64 / sizeof(FT);

  void flush()
  {
    for (std::size_t v = 0; v < m_vertices; ++v)
      for (std::size_t c = 0; c < 3; ++c) {
        FT* const row = m_fields[c]->row(v) + m_first;
        for (std::size_t f = 0; f < m_number_gathered; ++f) row[f] = m_gathered[(f * m_vertices + v) * 3 + c];
      }
    m_first += m_number_gathered;
    m_number_gathered = 0;
  }

  std::size_t m_vertices;
  std::array<Field*, 3> m_fields;
  std::vector<FT> m_gathered; // frame by frame
  std::size_t m_first = 0;    // the first gathered frame
  std::size_t m_number_gathered = 0;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FIELD_FILLER_H
