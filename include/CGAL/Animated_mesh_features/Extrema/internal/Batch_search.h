// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_BATCH_SEARCH_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_BATCH_SEARCH_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Candidate_verifier.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Extremum.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_batch.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_weights.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Temporal_weights.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Time_axis.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/join_equal_extrema.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The search in a batch of space levels: detects candidates, keeps those that are extrema in double precision, and leaves
// one of those that are equal and belong together.
template <class TemporalFilter, class Search>
class Batch_search
{
public:
  Batch_search(const Rest_shape& shape, const Level_batch& batch, const Level_weights& weights, const Time_axis& time_axis,
               const Search& search, std::size_t time_levels, Temporal_weights<TemporalFilter>& temporal_weights)
    : m_shape(shape)
    , m_time_axis(time_axis)
    , m_below(batch.below)
    , m_above(batch.above)
    , m_time_levels(time_levels)
    , m_weights(temporal_weights)
    , m_verifier(shape, batch, weights, time_axis, search)
  {}

  // Detects and verifies the candidates of some vertices at a time, which bounds their memory.
  template <class Candidate_detector, class Loop>
  void find(const Candidate_detector& detector, const Loop& loop, std::vector<Extremum>& extrema)
  {
    constexpr std::size_t vertices_at_once = std::size_t(1) << 14;
    const std::size_t n = m_shape.number_of_vertices(), parts = (n + vertices_at_once - 1) / vertices_at_once;
    for (std::size_t part = 0; part < parts; ++part) {
      const std::size_t first = part * vertices_at_once, last = (std::min)(n, first + vertices_at_once);
      const auto part_loop = loop.part(part, parts);
      std::vector<Candidate> candidates = detect_candidates(detector, first, last, part_loop.part(0, 2));
      verify(candidates, part_loop.part(1, 2), extrema);
    }
  }

  // Leaves one of equal extrema that belong together.
  template <class Loop>
  void join(const Loop& loop, std::vector<Extremum>& extrema)
  {
    const Extrema_of_like_scale like(extrema, m_time_axis);
    std::vector<std::vector<std::size_t>> with_equals(m_time_levels); // by time level
    for (std::size_t i = 0; i < extrema.size(); ++i)
      if (like.has_equal(i)) with_equals[extrema[i].l].push_back(i);
    std::vector<std::vector<Rest_shape::Index>> reached(extrema.size());
    for (std::size_t l = 0; l < m_time_levels; ++l) {
      if (with_equals[l].empty()) continue;
      const auto level_loop = loop.part(l, m_time_levels);
      m_weights.set_window(l - 1 - m_below, l + 2 + m_above, level_loop.part(0, 2));
      level_loop.part(1, 2)(with_equals[l].size(), [&](std::size_t task) {
        typename Temporal_weights<TemporalFilter>::Rows rows(m_weights);
        const std::size_t i = with_equals[l][task];
        const Extremum& e = extrema[i];
        rows.seek(l - 1 - m_below, l + 2 + m_above, e.frame);
        reached[i] = reached_from(m_shape, e, [&](std::size_t v) { return m_verifier.response(v, e.k, l, e.frame, rows); });
      });
    }
    join_equal_extrema(m_shape, like, reached, extrema);
    loop.finish();
  }

private:
  template <class Candidate_detector, class Loop>
  std::vector<Candidate> detect_candidates(const Candidate_detector& detector, std::size_t first_vertex,
                                           std::size_t last_vertex, const Loop& loop) const
  {
    constexpr std::size_t vertices_per_task = 8;
    std::vector<std::vector<Candidate>> detected((last_vertex - first_vertex + vertices_per_task - 1) /
                                                 vertices_per_task); // in order, whichever thread finds them
    loop(detected.size(), [&](std::size_t task) {
      const std::size_t first = first_vertex + task * vertices_per_task;
      detector(first, (std::min)(last_vertex, first + vertices_per_task), detected[task]);
    });
    std::vector<Candidate> all;
    for (std::vector<Candidate>& p : detected) {
      all.insert(all.end(), p.begin(), p.end());
      std::vector<Candidate>().swap(p);
    }
    return all;
  }

  // Keeps the candidates that are extrema; time levels come in windows, as there are weights for one window at a time.
  template <class Loop>
  void verify(std::vector<Candidate>& candidates, const Loop& loop, std::vector<Extremum>& extrema)
  {
    constexpr std::size_t candidates_per_task = 64;
    const std::size_t window = m_weights.window_size();
    const std::size_t verified_at_once = window - (m_below + m_above + 2); // a window has a response on either side of them
    const std::size_t first = m_below + 1, last = m_time_levels - m_above - 1;
    const std::size_t windows = (last - first + verified_at_once - 1) / verified_at_once;
    if (windows > 1)
      std::stable_sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
        return (a.l - first) / verified_at_once < (b.l - first) / verified_at_once;
      });
    auto next = candidates.begin();
    for (std::size_t i = 0; i < windows; ++i) {
      const std::size_t begin = first + i * verified_at_once, end = (std::min)(last, begin + verified_at_once);
      const auto window_end =
          std::find_if(next, candidates.end(), [&](const Candidate& c) { return c.l >= end; });
      if (next == window_end) continue;
      const auto window_loop = loop.part(i, windows);
      m_weights.set_window(begin - 1 - m_below, end + 1 + m_above, window_loop.part(0, 8));
      const std::size_t size = std::size_t(window_end - next);
      std::vector<std::vector<Extremum>> found((size + candidates_per_task - 1) / candidates_per_task);
      const auto at = next;
      window_loop.part(1, 2)(found.size(), [&](std::size_t task) {
        typename Temporal_weights<TemporalFilter>::Rows rows(m_weights);
        Extremum extremum;
        for (std::size_t j = task * candidates_per_task; j < (std::min)(size, (task + 1) * candidates_per_task); ++j)
          if (m_verifier(at[std::ptrdiff_t(j)], rows, extremum)) found[task].push_back(extremum);
      });
      for (std::vector<Extremum>& f : found)
        extrema.insert(extrema.end(), std::make_move_iterator(f.begin()), std::make_move_iterator(f.end()));
      next = window_end;
    }
    loop.finish();
  }

  const Rest_shape& m_shape;
  Time_axis m_time_axis;
  std::size_t m_below, m_above, m_time_levels;
  Temporal_weights<TemporalFilter>& m_weights;
  Candidate_verifier<TemporalFilter, Search> m_verifier;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_BATCH_SEARCH_H
