// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TEMPORAL_MATRICES_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TEMPORAL_MATRICES_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Whether a temporal filter takes rows of several vertices at once.
template <class Filter, class = void>
struct Is_vectorized_filter : std::false_type
{
};
template <class Filter>
struct Is_vectorized_filter<Filter, std::enable_if_t<Filter::vectorized>> : std::true_type
{
};

// The matrices of the levels of a temporal filter, T_l, for a window of levels that moves upwards: row f of T_l holds
// the weights of all frames in frame f of level l. F^2 numbers a level.
template <class TemporalFilter>
class Temporal_matrices
{
public:
  Temporal_matrices(const TemporalFilter& filter, std::size_t number_of_frames, std::size_t number_of_levels)
    : m_filter(filter)
    , m_frames(number_of_frames)
    , m_levels(number_of_levels)
    , m_stride((number_of_frames + pack_size - 1) / pack_size * pack_size)
  {
  }

  // Makes the levels [first, last) available, by `loop`; those before are dropped. Going back starts anew.
  template <class Loop>
  void set_window(std::size_t first, std::size_t last, const Loop& loop)
  {
    if (first >= m_first && last <= m_last) return;
    const bool goes_on = first >= m_first && first < m_last && last > m_last;
    const std::size_t size = m_stride * m_frames;
    std::vector<double> values((last - first) * size);
    if (goes_on) std::copy(m_values.begin() + std::ptrdiff_t((first - m_first) * size),
                           m_values.end(), values.begin());
    const std::size_t from = goes_on ? m_last : 0;
    const double* before = goes_on ? values.data() + (m_last - 1 - first) * size : nullptr;
    loop(m_stride / pack_size, [&](std::size_t group) { smooth_impulses(group, before, from, first, last, values); });
    m_values.swap(values);
    m_first = first;
    m_last = last;
  }

  // As many levels as fit into a moderate amount of memory, at least `least`.
  std::size_t window_size(std::size_t least) const
  {
    constexpr std::size_t bytes = std::size_t(1) << 26;
    return (std::min)(m_levels, (std::max)(least, bytes / (m_stride * m_frames * sizeof(double))));
  }

  // `stride()` numbers, those from the number of frames on zero.
  const double* row(std::size_t l, std::size_t f) const
  {
    return m_values.data() + ((l - m_first) * m_frames + f) * m_stride;
  }

  std::size_t stride() const { return m_stride; }

private:
  static constexpr std::size_t pack_size = 8;

  // The columns of a group: impulses in `pack_size` successive frames, smoothed.
  void smooth_impulses(std::size_t group, const double* before, std::size_t from, std::size_t first, std::size_t last,
                       std::vector<double>& values) const
  {
    const std::size_t size = m_stride * m_frames, column = group * pack_size;
    const auto smooth = [&](auto& row, auto& next, const auto& load, const auto& store) {
      for (std::size_t f = 0; f < m_frames; ++f) load(f, row[f]);
      for (std::size_t l = from; l < last; ++l) {
        m_filter(l, row.data(), next.data());
        row.swap(next);
        if (l >= first)
          for (std::size_t f = 0; f < m_frames; ++f)
            store(row[f], values.data() + (l - first) * size + f * m_stride + column);
      }
    };
    const auto entry = [&](std::size_t f, std::size_t i) {
      return before != nullptr ? before[f * m_stride + column + i] : double(f == column + i);
    };
    if constexpr (Is_vectorized_filter<TemporalFilter>::value) {
      typedef Pack<double, pack_size, Baseline_register<double>::value> Block;
      std::vector<Block> row(m_frames), next(m_frames);
      const auto load = [&](std::size_t f, Block& block) {
        double numbers[pack_size];
        for (std::size_t i = 0; i < pack_size; ++i) numbers[i] = entry(f, i);
        block = Block::load(numbers);
      };
      smooth(row, next, load, [](const Block& block, double* to) { block.store(to); });
    } else {
      std::vector<double> row(m_frames), next(m_frames);
      for (std::size_t i = 0; i < pack_size && column + i < m_frames; ++i)
        smooth(row, next, [&](std::size_t f, double& number) { number = entry(f, i); },
               [&](double number, double* to) { to[i] = number; });
    }
  }

  const TemporalFilter& m_filter;
  std::size_t m_frames, m_levels, m_stride;
  std::size_t m_first = 0, m_last = 0;
  std::vector<double> m_values; // [l - first][f][j]
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TEMPORAL_MATRICES_H
