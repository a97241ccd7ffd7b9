// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TEMPORAL_MATRICES_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TEMPORAL_MATRICES_H

#include <CGAL/Animated_mesh_features/Extrema/internal/Temporal_filter_traits.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The matrices T_l of a temporal filter, row f of which has the weights of all frames in frame f of level l, for a window of
// levels that moves upwards; made by smoothing impulses.
template <class TemporalFilter>
class Temporal_matrices
{
  static constexpr std::size_t pack_size = 8;
  static constexpr bool is_symmetric = Is_mirror_symmetric<TemporalFilter>::value;

  static std::size_t padded(std::size_t frames) { return (frames + pack_size - 1) / pack_size * pack_size; }

public:
  // The filter is kept by reference.
  Temporal_matrices(const TemporalFilter& filter, std::size_t number_of_frames)
    : m_filter(filter)
    , m_frames(number_of_frames)
    , m_stride(padded(number_of_frames))
  {}

  // How many of them fit into so many bytes.
  static std::size_t number_that_fits(std::size_t number_of_frames, std::size_t bytes)
  {
    return bytes / (padded(number_of_frames) * number_of_frames * sizeof(double));
  }

  // Makes the levels [first, last) available, by `loop`, with memory for `reserved` of them at least; those before are
  // dropped. Going back starts anew.
  template <class Loop>
  void set_window(std::size_t first, std::size_t last, std::size_t reserved, const Loop& loop)
  {
    const bool goes_on = first >= m_first && first < m_last && last > m_last;
    const std::size_t size = m_stride * m_frames;
    if (goes_on) // in place: there are never two windows in memory
      m_values.erase(m_values.begin(), m_values.begin() + std::ptrdiff_t((first - m_first) * size));
    else
      m_values.clear();
    if (m_values.capacity() < (last - first) * size) m_values.reserve((std::max)(last - first, reserved) * size);
    m_values.resize((last - first) * size);
    const std::size_t from = goes_on ? m_last : 0;
    const double* before = goes_on ? m_values.data() + (m_last - 1 - first) * size : nullptr;
    // of a symmetric filter the first half of the columns tells the others
    const std::size_t columns = is_symmetric ? (m_frames + 1) / 2 : m_frames;
    loop((columns + pack_size - 1) / pack_size, [&](std::size_t group) {
      Impulse_loop impulses = {*this, group, before, from, first, last, m_values};
      if constexpr (Is_vectorized_filter<TemporalFilter>::value)
        run_reproducibly<double>(widest_instruction_set(), impulses);
      else
        impulses.template run<Baseline_register<double>::value>();
    });
    m_first = first;
    m_last = last;
  }

  // The weight of frame 0 in frame f of level l, those of the others after it.
  const double* row(std::size_t l, std::size_t f) const
  {
    return m_values.data() + ((l - m_first) * m_frames + f) * m_stride;
  }

private:
  struct Impulse_loop
  {
    const Temporal_matrices& matrices;
    std::size_t group;
    const double* before;
    std::size_t from, first, last;
    std::vector<double>& values;

    template <std::size_t bytes>
    void run()
    {
      matrices.template smooth_impulses<bytes>(group, before, from, first, last, values);
    }
  };

  // Writes some numbers of frame f of a matrix, from a column on; with a symmetric filter those of the first half only,
  // and what they tell of the second.
  void write(const double* numbers, std::size_t count, std::size_t f, std::size_t column, double* matrix) const
  {
    for (std::size_t j = column; j < (std::min)(column + count, m_frames); ++j) {
      const std::size_t opposite = m_frames - 1 - j;
      if (is_symmetric && j > opposite) break;
      matrix[f * m_stride + j] = numbers[j - column];
      if (is_symmetric && j < opposite) matrix[(m_frames - 1 - f) * m_stride + opposite] = numbers[j - column];
    }
  }

  // The columns of a group: impulses in `pack_size` successive frames, smoothed.
  template <std::size_t bytes>
  void smooth_impulses(std::size_t group, const double* before, std::size_t from, std::size_t first, std::size_t last,
                       std::vector<double>& values) const
  {
    const std::size_t size = m_stride * m_frames, column = group * pack_size;
    const auto smooth = [&](auto& row, auto& next, std::size_t i, std::size_t count, const auto& load,
                            const auto& store) {
      for (std::size_t f = 0; f < m_frames; ++f) load(f, row[f]);
      for (std::size_t l = from; l < last; ++l) {
        m_filter(l, row.data(), next.data());
        row.swap(next);
        if (l >= first)
          for (std::size_t f = 0; f < m_frames; ++f) {
            double numbers[pack_size] = {};
            store(row[f], numbers);
            write(numbers, count, f, column + i, values.data() + (l - first) * size);
          }
      }
    };
    const auto entry = [&](std::size_t f, std::size_t i) {
      return before != nullptr ? before[f * m_stride + column + i] : double(f == column + i);
    };
    if constexpr (Is_vectorized_filter<TemporalFilter>::value) {
      typedef Pack<double, pack_size, bytes> Block;
      std::vector<Block> row(m_frames), next(m_frames);
      const auto load = [&](std::size_t f, Block& block) {
        double numbers[pack_size];
        for (std::size_t i = 0; i < pack_size; ++i) numbers[i] = entry(f, i);
        block = Block::load(numbers);
      };
      smooth(row, next, 0, pack_size, load, [](const Block& block, double* to) { block.store(to); });
    } else {
      std::vector<double> row(m_frames), next(m_frames);
      for (std::size_t i = 0; i < pack_size && column + i < m_frames; ++i)
        smooth(row, next, i, 1, [&](std::size_t f, double& number) { number = entry(f, i); },
               [&](double number, double* to) { *to = number; });
    }
  }

  const TemporalFilter& m_filter;
  std::size_t m_frames, m_stride;
  std::size_t m_first = 0, m_last = 0;
  std::vector<double> m_values; // [l - first][f][j]
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TEMPORAL_MATRICES_H
