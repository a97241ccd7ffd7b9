// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_READ_FRAME_PIECES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_READ_FRAME_PIECES_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>
#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Numerics/all_finite.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>
#include <CGAL/Animated_mesh_features/Animation/transpose_frames.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Frames in single precision, one after the other from `offset` to the end of a file, vertex by vertex.
struct Frames_in_file
{
  std::FILE* file;
  std::uint64_t offset;
  std::size_t points, frames;
  Byte_order order;

  std::uint64_t position(std::size_t frame, std::size_t point) const
  {
    return offset + 3 * sizeof(float) * (std::uint64_t(frame) * points + point);
  }
};

// Reads the frames by pieces, on several threads, into fields whose rows are vertices: a piece is still in the cache
// when it is transposed, and nothing as large as a frame is in memory beside the fields. `false`, with anything in the
// fields, if a piece cannot be read, a position is not finite, or the file goes on: who reads it from its start finds
// the first error.
template <class ConcurrencyTag, class FT>
bool read_frame_pieces(const Frames_in_file& in, const std::array<Spatio_temporal_field<FT>*, 3>& fields)
{
  using Animated_mesh_features::internal::all_finite;
  using Animated_mesh_features::internal::Frame_piece;
  using Animated_mesh_features::internal::vertices_of_piece;
  // Runs of 12 kB, long enough for a call of the system, and 0.4 MB in all, half of a usual second-level cache.
  constexpr std::size_t vertices_at_once = 4 * vertices_of_piece, frames_at_once = 32;
  typedef std::vector<float> Buffer;
  Animated_mesh_features::internal::Thread_local<Buffer> buffers;
  const std::size_t runs = (in.points + vertices_at_once - 1) / vertices_at_once;
  std::atomic<bool> good(true);
  for (std::size_t first = 0; first < in.frames && good; first += frames_at_once) {
    const std::size_t frames = (std::min)(frames_at_once, in.frames - first);
    parallel_for<ConcurrencyTag>(0, runs, [&](std::size_t i) {
      Buffer& xyz = buffers.get([] { return std::make_unique<Buffer>(3 * vertices_at_once * frames_at_once); });
      const std::size_t v = i * vertices_at_once, n = (std::min)(vertices_at_once, in.points - v);
      for (std::size_t f = 0; f < frames; ++f)
        if (!good || !read_bytes_at(in.file, reinterpret_cast<char*>(xyz.data() + 3 * f * n), 3 * sizeof(float) * n,
                                    in.position(first + f, v))) {
          good = false;
          return;
        }
      convert_from(in.order, xyz.data(), 3 * frames * n);
      if (!all_finite(xyz.data(), 3 * frames * n)) {
        good = false;
        return;
      }
      for (std::size_t u = 0; u < n; u += vertices_of_piece) {
        const Frame_piece piece = {v + u, (std::min)(vertices_of_piece, n - u), first, frames};
        const auto frame = [&](std::size_t f) { return static_cast<const float*>(xyz.data()) + 3 * (f * n + u); };
        Animated_mesh_features::internal::transpose_frames(piece, frame, fields);
      }
    });
  }
  char one;
  return good && !read_bytes_at(in.file, &one, 1, in.position(in.frames, 0));
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_READ_FRAME_PIECES_H
