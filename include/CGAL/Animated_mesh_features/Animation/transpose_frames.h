// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_TRANSPOSE_FRAMES_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_TRANSPOSE_FRAMES_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Vertices in a row, and frames in a row: a piece of an animation, which is transposed at once.
struct Frame_piece
{
  std::size_t first_vertex, vertices;
  std::size_t first_frame, frames;
};

// So many vertices that their rows are still in the cache when the next few frames are added to them, and that the
// memory of a frame is used in long runs.
constexpr std::size_t vertices_of_piece = 256;

// Writes a piece into the rows of x, y and z. `xyz(f)` points to the coordinates, vertex by vertex, of the f-th frame
// of the piece. Frames are taken four at a time: few streams to read, and a row is written in more than single numbers.
template <class FT, class Frame>
void transpose_frames(const Frame_piece& piece, const Frame& xyz,
                      const std::array<Spatio_temporal_field<FT>*, 3>& fields)
{
  const std::size_t stride = fields[0]->stride();
  for (std::size_t f = 0; f < piece.frames;) {
    FT* rows[3];
    for (std::size_t c = 0; c < 3; ++c) rows[c] = fields[c]->row(piece.first_vertex) + piece.first_frame + f;
    if (f + 4 <= piece.frames) {
      const auto *a = xyz(f), *b = xyz(f + 1), *c = xyz(f + 2), *d = xyz(f + 3);
      for (std::size_t v = 0; v < piece.vertices; ++v)
        for (std::size_t i = 0; i < 3; ++i) {
          FT* const row = rows[i] + v * stride;
          row[0] = static_cast<FT>(a[3 * v + i]);
          row[1] = static_cast<FT>(b[3 * v + i]);
          row[2] = static_cast<FT>(c[3 * v + i]);
          row[3] = static_cast<FT>(d[3 * v + i]);
        }
      f += 4;
    } else {
      const auto* const a = xyz(f);
      for (std::size_t v = 0; v < piece.vertices; ++v)
        for (std::size_t i = 0; i < 3; ++i) rows[i][v * stride] = static_cast<FT>(a[3 * v + i]);
      ++f;
    }
  }
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_TRANSPOSE_FRAMES_H
