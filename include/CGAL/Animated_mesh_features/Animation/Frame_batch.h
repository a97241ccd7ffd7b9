// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_FRAME_BATCH_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_FRAME_BATCH_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>
#include <CGAL/Animated_mesh_features/Animation/transpose_frames.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

Turns frames that come vertex by vertex into fields whose rows are vertices. A frame alone would touch a cache line of
every row for one number; frames are therefore gathered, some at once, before they are transposed. Those of a batch may be
written in any order, from several threads.

\code
Frame_batch<double, CGAL::Parallel_if_available_tag> batch({{&x, &y, &z}}, 8);
for (std::size_t f = 0; f < number_of_frames; ++f) {
  read_frame(f, batch.frame(f)); // 3 N numbers
  if (f + 1 == batch.end()) batch.finish();
}
\endcode

\tparam FT `float` or `double`.
\tparam ConcurrencyTag whether batches are transposed on several threads.
*/
template <class FT, class ConcurrencyTag>
class Frame_batch
{
public:
  typedef std::array<Spatio_temporal_field<FT>*, 3> Fields; ///< x, y and z

  /// gathers frames for fields that are there.
  /// \param fields which have their size.
  /// \param frames_at_once best a multiple of what fits a cache line.
  Frame_batch(const Fields& fields, std::size_t frames_at_once)
    : m_vertices(fields[0]->number_of_rows())
    , m_frames(fields[0]->number_of_frames())
    , m_frames_at_once(frames_at_once)
    , m_fields(fields)
    , m_gathered(3 * m_vertices * (std::min)(frames_at_once, m_frames))
  {
  }

  /// `N`.
  std::size_t number_of_vertices() const { return m_vertices; }

  /// the end of the present batch of frames; the next one starts there.
  std::size_t end() const { return (std::min)(m_first + m_frames_at_once, m_frames); }

  /// where the coordinates of frame `f`, which is of the present batch, are to be written, vertex by vertex.
  FT* frame(std::size_t f) { return m_gathered.data() + (f - m_first) * 3 * m_vertices; }

  /// is to be called when all frames of the batch are there.
  void finish()
  {
    const std::size_t first = m_first, frames = end() - first;
    const std::size_t pieces = (m_vertices + internal::vertices_of_piece - 1) / internal::vertices_of_piece;
    parallel_for<ConcurrencyTag>(0, pieces, [&](std::size_t i) {
      const std::size_t v = i * internal::vertices_of_piece;
      const internal::Frame_piece piece = {v, (std::min)(internal::vertices_of_piece, m_vertices - v), first, frames};
      internal::transpose_frames(
          piece, [&](std::size_t f) { return static_cast<const FT*>(frame(first + f) + 3 * v); }, m_fields);
    });
    m_first += frames;
  }

private:
  std::size_t m_vertices, m_frames, m_frames_at_once;
  Fields m_fields;
  std::vector<FT> m_gathered; // the frames of the batch, one after the other
  std::size_t m_first = 0;    // of the batch
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_FRAME_BATCH_H
