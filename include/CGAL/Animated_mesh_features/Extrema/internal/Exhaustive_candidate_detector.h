// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_EXHAUSTIVE_CANDIDATE_DETECTOR_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_EXHAUSTIVE_CANDIDATE_DETECTOR_H

#include <CGAL/Animated_mesh_features/Extrema/Extremum_search.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_batch.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_weights.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Time_axis.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Finds the samples of a vertex that pass the search's own test at the vertex, for any temporal filter and any search.
template <class TemporalFilter, class Search>
class Exhaustive_candidate_detector
{
public:
  Exhaustive_candidate_detector(const Level_batch& batch, const Level_weights& weights, const Time_axis& time,
                                std::size_t time_levels, const TemporalFilter& temporal, const Search& search)
    : m_batch(batch)
    , m_weights(weights)
    , m_time(time)
    , m_frames(time.number_of_frames())
    , m_time_levels(time_levels)
    , m_temporal(temporal)
    , m_search(search)
  {
  }

  void operator()(std::size_t first_vertex, std::size_t last_vertex, std::vector<Candidate>& candidates) const
  {
    Responses responses;
    for (std::size_t v = first_vertex; v < last_vertex; ++v) {
      respond(v, responses);
      search(v, responses, candidates);
    }
  }

private:
  struct Responses
  {
    std::vector<double> smoothed;  // [space level of the batch][time level][frame]
    std::vector<double> responses; // likewise, each row with its margins
  };

  void search(std::size_t v, const Responses& w, std::vector<Candidate>& candidates) const
  {
    const std::size_t margin = m_time.margin(), width = m_frames + 2 * margin, plane = m_time_levels * width;
    for (std::size_t k = m_batch.first; k < m_batch.last; ++k)
      for (std::size_t l = m_batch.below + 1; l + m_batch.above + 1 < m_time_levels; ++l) {
        const double floor = m_weights.floor(k, l);
        const double* d = w.responses.data() + (k - (m_batch.first - 1)) * plane + l * width;
        for (std::size_t f = 1; f + 1 < width; ++f) {
          const Response_window<double> window(d + f - plane, d + f, d + f + plane, std::ptrdiff_t(width));
          // twice the rounding of the two ways to compute a response
          if (std::abs(d[f]) > floor * (1 - 1e-6) && m_search.at_vertex(window))
            candidates.push_back({std::uint32_t(v), std::uint32_t(f - margin), std::uint32_t(k), std::uint32_t(l)});
        }
      }
  }

  void respond(std::size_t v, Responses& w) const
  {
    const std::size_t plane = m_time_levels * m_frames, l0 = m_batch.first_level(), l1 = m_batch.last_level();
    w.smoothed.resize((l1 - l0) * plane);
    const auto smoothed = [&](std::size_t k, std::size_t l) {
      return w.smoothed.data() + (k - l0) * plane + l * m_frames;
    };
    for (std::size_t k = l0; k < l1; ++k) {
      m_temporal(0, m_batch.row(k, v), smoothed(k, 0));
      for (std::size_t l = 1; l < m_time_levels; ++l) m_temporal(l, smoothed(k, l - 1), smoothed(k, l));
    }
    const std::size_t k0 = m_batch.first - 1, k1 = m_batch.last + 1;
    const std::size_t margin = m_time.margin(), width = m_frames + 2 * margin;
    w.responses.assign((k1 - k0) * m_time_levels * width, 0);
    for (std::size_t k = k0; k < k1; ++k)
      for (std::size_t l = m_batch.below; l + m_batch.above < m_time_levels; ++l) {
        const double factor = m_weights.factor(v, k);
        const double a = m_weights.space(k, l) * factor, b = m_weights.time(k, l) * factor;
        const double *s1 = smoothed(k + m_batch.above, l), *s0 = smoothed(k - m_batch.below, l);
        const double *t1 = smoothed(k, l + m_batch.above), *t0 = smoothed(k, l - m_batch.below);
        double* const row = w.responses.data() + ((k - k0) * m_time_levels + l) * width;
        double* const d = row + margin;
        for (std::size_t f = 0; f < m_frames; ++f) d[f] = a * (s1[f] - s0[f]) + b * (t1[f] - t0[f]);
        m_time.join_ends(row);
      }
  }

  const Level_batch& m_batch;
  const Level_weights& m_weights;
  const Time_axis m_time;
  std::size_t m_frames, m_time_levels;
  const TemporalFilter& m_temporal;
  const Search& m_search;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_EXHAUSTIVE_CANDIDATE_DETECTOR_H
