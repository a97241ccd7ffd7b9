// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_PACKED_WEIGHTS_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_PACKED_WEIGHTS_H

#include <CGAL/Animated_mesh_features/Extrema/internal/Level_batch.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_weights.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The weights of a batch, as packs: one for each time level, with those of all space levels; the responses at
// [batch.first - 1, batch.last + 1) are the first of its entries. The weights of entries without a level are zero.
template <class T>
class Packed_weights
{
public:
  Packed_weights(const Level_weights& weights, const Level_batch& batch, std::size_t time_levels, std::size_t pack_size)
    : m_weights(weights)
    , m_batch(batch)
    , m_pack_size(pack_size)
    , m_space(time_levels * pack_size, 0)
    , m_time(time_levels * pack_size, 0)
    , m_floor(time_levels * pack_size, 0)
  {
    for (std::size_t l = batch.below; l + batch.above < time_levels; ++l)
      for (std::size_t k = batch.first - 1; k < batch.last + 1; ++k) {
        const std::size_t i = l * pack_size + k - (batch.first - 1);
        m_space[i] = T(weights.space(k, l));
        m_time[i] = T(weights.time(k, l));
        m_floor[i] = T(weights.floor(k, l));
      }
  }

  // Of a vertex: the factors of all space levels, for a pack of `numbers`.
  bool has_factors() const { return m_weights.has_factors(); }
  void factors(std::size_t v, T* numbers) const
  {
    const std::size_t first = m_batch.first - 1, levels = m_batch.last + 1 - first;
    for (std::size_t i = 0; i < m_pack_size; ++i) numbers[i] = i < levels ? T(m_weights.factor(v, first + i)) : T(0);
  }

  const T* space(std::size_t l) const { return m_space.data() + l * m_pack_size; }
  const T* time(std::size_t l) const { return m_time.data() + l * m_pack_size; }
  const T* floor(std::size_t l) const { return m_floor.data() + l * m_pack_size; }

private:
  const Level_weights& m_weights;
  const Level_batch& m_batch;
  std::size_t m_pack_size;
  std::vector<T> m_space, m_time, m_floor; // [l][entry of the pack]
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_PACKED_WEIGHTS_H
