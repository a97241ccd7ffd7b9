// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TEMPORAL_WEIGHTS_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TEMPORAL_WEIGHTS_H

#include <CGAL/Animated_mesh_features/Extrema/internal/Temporal_filter_traits.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Temporal_matrices.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>
#include <CGAL/Animated_mesh_features/Scale_space/is_periodic.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The weights of all frames in a frame of a level of a temporal filter, for a window of levels that moves upwards: row
// f of the level's matrix T_l. Matrices have F^2 numbers a level; where these would be too many, rows are made of the
// filter's weights by distance when they are asked for, if it tells them, as all filters do that weigh by distance and
// continue a row by its mirror image, T_l(f, j) = w_l(f - j) + w_l(f + j + 1) on a circle of 2 F frames, or by itself,
// T_l(f, j) = w_l(f - j) on a circle of F frames.
template <class TemporalFilter>
class Temporal_weights
{
public:
  // `least_window` levels are needed at a time; matrices of these are taken if they fit into `bytes`.
  Temporal_weights(const TemporalFilter& filter, std::size_t number_of_frames, std::size_t number_of_levels,
                   std::size_t least_window, std::size_t bytes = std::size_t(1) << 26)
    : m_filter(filter)
    , m_frames(number_of_frames)
    , m_levels(number_of_levels)
    , m_least_window((std::min)(number_of_levels, least_window))
    , m_fitting(Temporal_matrices<TemporalFilter>::number_that_fits(number_of_frames, bytes))
    , m_matrices(filter, number_of_frames)
  {
    if constexpr (Has_weights_by_distance<TemporalFilter>::value)
      m_is_by_distance = (number_of_frames > most_frames_of_matrices || m_least_window > m_fitting) &&
                         (filter.reflects() || is_periodic(filter));
  }

  // Makes the levels [first, last) available, by `loop`; those before are dropped. Going back starts anew.
  template <class Loop>
  void set_window(std::size_t first, std::size_t last, const Loop& loop)
  {
    if (first >= m_first && last <= m_last) return;
    if constexpr (Has_weights_by_distance<TemporalFilter>::value)
      if (m_is_by_distance) {
        m_by_distance.resize(last - first);
        loop.part(0, 2)(last - first, [&](std::size_t i) {
          m_by_distance[i] = shortened(m_filter.weights_by_distance(first + i));
        });
        m_first = first;
        m_last = last;
        m_two_sided.resize(last - first);
        loop.part(1, 2)(last - first, [&](std::size_t i) { m_two_sided[i] = two_sided(i); });
        return;
      }
    m_matrices.set_window(first, last, window_size(), loop);
    m_first = first;
    m_last = last;
  }

  // The levels of a window: as many as fit into a moderate amount of memory, but never less than are needed.
  std::size_t window_size() const
  {
    return m_is_by_distance ? m_levels : (std::min)(m_levels, (std::max)(m_least_window, m_fitting));
  }

  // Rows of the levels of the window around some frame, for one thread.
  class Rows
  {
  public:
    explicit Rows(const Temporal_weights& weights) : m_weights(weights) {}

    // Rows of levels [first, last) in frame `frame`, the one before and the one after it are asked for next; of a periodic
    // filter, the last frame is before the first.
    void seek(std::size_t first, std::size_t last, std::size_t frame)
    {
      const std::size_t n = m_weights.m_frames;
      m_end = n;
      if (!m_weights.m_is_by_distance) return;
      const std::size_t reach = m_weights.reach(first, last);
      m_is_inside = frame >= reach && frame + reach < n;
      const bool goes_round = !m_is_inside && is_periodic(m_weights.m_filter);
      m_begin = frame > reach && !goes_round ? frame - reach : 0;
      m_end = goes_round ? n : (std::min)(n, frame + reach + 1);
      m_first = first;
      m_frame = frame;
      if (m_is_inside) return;
      m_is_known.assign(3 * (last - first), 0);
      m_rows.resize(3 * (last - first) * (m_end - m_begin));
    }

    // Frames [begin(), end()) are all that have weights in the rows that are asked for.
    std::size_t begin() const { return m_begin; }
    std::size_t end() const { return m_end; }

    // The weight of frame begin() in frame f of level l, those of the following frames after it.
    const double* row(std::size_t l, std::size_t f)
    {
      if (!m_weights.m_is_by_distance) return m_weights.m_matrices.row(l, f);
      if (m_is_inside) return m_weights.own_weight(l) - (f - m_begin);
      const std::size_t nth = f == m_frame ? 1 : f + 1 == m_frame || (m_frame == 0 && f != 1) ? 0 : 2;
      const std::size_t i = 3 * (l - m_first) + nth;
      double* const row = m_rows.data() + i * (m_end - m_begin);
      if (!m_is_known[i]) make_row(l, f, row);
      m_is_known[i] = 1;
      return row;
    }

  private:
    void make_row(std::size_t l, std::size_t f, double* row) const
    {
      const std::vector<double>& weights = m_weights.by_distance(l);
      const std::size_t n = m_weights.m_frames, size = weights.size();
      if (is_periodic(m_weights.m_filter)) {
        for (std::size_t j = 0; j < n; ++j) {
          const std::size_t distance = j < f ? f - j : j - f, around = (std::min)(distance, n - distance);
          row[j] = around < size ? weights[around] : 0;
        }
        return;
      }
      const double* const own = m_weights.own_weight(l);
      std::copy(own - (f - m_begin), own + (m_end - f), row); // own[i] == own[-i]
      // the mirror images before the first frame and after the last one
      const std::size_t to_first = f + m_begin + 1; // from the image of frame m_begin
      if (to_first < size) add(weights.data() + to_first, (std::min)(m_end - m_begin, size - to_first), row);
      const std::size_t distance = 2 * n - 1 - f; // to the image of frame 0, and less to those after it
      // what is n away was added above
      const std::size_t first = (std::max)(m_begin, distance + 1 - (std::min)(size, n));
      if (first < m_end) add(own - (distance - first), m_end - first, row + (first - m_begin));
    }

    static void add(const double* weights, std::size_t count, double* row)
    {
      typedef Pack<double, 8, Baseline_register<double>::value> Block;
      std::size_t i = 0;
      for (; i + Block::size <= count; i += Block::size) (Block::load(row + i) + Block::load(weights + i)).store(row + i);
      for (; i < count; ++i) row[i] += weights[i];
    }

    const Temporal_weights& m_weights;
    std::size_t m_begin = 0, m_end = 0, m_first = 0, m_frame = 0;
    bool m_is_inside = false; // no image has a weight: rows are parts of the weights of a level, as they are
    std::vector<char> m_is_known;
    std::vector<double> m_rows; // [level][frame][j - begin]
  };

private:
  // Rows of more frames are made of weights by distance where they can.
  static constexpr std::size_t most_frames_of_matrices = 1024;

  const std::vector<double>& by_distance(std::size_t l) const { return m_by_distance[l - m_first]; }

  // Beyond it no row of the levels [first, last) has weights, for a frame or one next to it.
  std::size_t reach(std::size_t first, std::size_t last) const
  {
    std::size_t result = 1;
    for (std::size_t l = first; l < last; ++l) result = (std::max)(result, by_distance(l).size() + 1);
    return result;
  }

  // The weights of level m_first + i on either side of a frame, with zeros as far as any level that is asked for
  // together with it reaches from a frame next to it.
  std::vector<double> two_sided(std::size_t i) const
  {
    const std::size_t l = m_first + i, levels = m_least_window;
    const std::size_t half =
        reach(l > m_first + levels ? l - levels : m_first, (std::min)(m_last, l + levels + 1)) + 1;
    const std::vector<double>& weights = m_by_distance[i];
    std::vector<double> result(2 * half + 1, 0);
    for (std::size_t d = 0; d < weights.size(); ++d) result[half + d] = result[half - d] = weights[d];
    return result;
  }

  // The weight that a frame of a level has itself, among those on either side.
  const double* own_weight(std::size_t l) const
  {
    const std::vector<double>& weights = m_two_sided[l - m_first];
    return weights.data() + weights.size() / 2;
  }

  // Without the weights that vanish beside the sum, 1.
  static std::vector<double> shortened(std::vector<double> weights)
  {
    while (weights.size() > 1 && weights.back() < 1e-18) weights.pop_back();
    return weights;
  }

  const TemporalFilter& m_filter;
  std::size_t m_frames, m_levels, m_least_window, m_fitting;
  Temporal_matrices<TemporalFilter> m_matrices;
  bool m_is_by_distance = false;
  std::size_t m_first = 0, m_last = 0;
  std::vector<std::vector<double>> m_by_distance; // [l - first][distance]
  std::vector<std::vector<double>> m_two_sided;   // the same on either side of the middle
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TEMPORAL_WEIGHTS_H
