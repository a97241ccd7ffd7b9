// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_RESPONSE_LANES_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_RESPONSE_LANES_H

#include <CGAL/Animated_mesh_features/internal/Lane_weights.h>
#include <CGAL/Animated_mesh_features/internal/Lanes.h>
#include <CGAL/Animated_mesh_features/internal/Level_batch.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The responses of one vertex at three successive time levels, a lane for each space level, and the search for minima
// among them. Time levels are pushed in ascending order; a level is searched when the next one has come.
//
// Most of the work is rejecting: of all samples only the minima over time, a few frames of a level, are compared with
// their neighbours in scale.
template <class L>
class Response_lanes
{
public:
  typedef typename L::Scalar T;

  explicit Response_lanes(std::size_t number_of_frames)
    : m_frames(number_of_frames)
    , m_slacks(3 * L::size, 0)
  {
    for (std::vector<L>& level : m_levels) level.assign(number_of_frames, L::all(0));
  }

  // What comes next is time level `first` of another vertex.
  void start(std::size_t first)
  {
    m_next = m_first = first;
    m_minima.clear();
    m_first_new = 0;
  }

  // Pushes a level: response(f) for each frame, of which two may differ by `slack` more than they seem to.
  template <class Response>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void push(const L& slack, const L& floor, const Response& response)
  {
    L* const d = row(m_next);
    slack.store(slacks(m_next));
    m_first_old = m_first_new;
    m_first_new = m_minima.size();
    const L bound = slack - floor;
    L before = response(0), now = response(1);
    d[0] = before;
    d[1] = now;
    const auto is_minimum = [&](const L& next) CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA {
      const L lowered = now - slack;
      return negative(lowered - before) & negative(lowered - next) & negative(now - bound);
    };
    const auto step = [&](std::size_t f) CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA {
      const L next = response(f);
      d[f] = next;
      const auto result = is_minimum(next);
      before = now;
      now = next;
      return result;
    };
    std::size_t f = 2;
    // Asking whether there is a minimum costs as much as looking for it: once for some frames, and again only if so.
    constexpr std::size_t frames_at_once = 4;
    for (; f + frames_at_once <= m_frames; f += frames_at_once) {
      const auto s0 = step(f), s1 = step(f + 1), s2 = step(f + 2), s3 = step(f + 3);
      if (!((s0 | s1) | (s2 | s3)).any()) continue;
      if (s0.any()) m_minima.push_back(f - 1);
      if (s1.any()) m_minima.push_back(f);
      if (s2.any()) m_minima.push_back(f + 1);
      if (s3.any()) m_minima.push_back(f + 2);
    }
    for (; f < m_frames; ++f)
      if (step(f).any()) m_minima.push_back(f - 1);
    ++m_next;
  }

  // Whether there is a level with one on either side: the last but one that was pushed.
  bool can_search() const { return m_next >= m_first + 3; }
  std::size_t searched_level() const { return m_next - 2; }

  // found(frame, lane) for each minimum of that level in lanes [1, last_lane).
  template <class Found>
  void search(const T* floor, std::size_t last_lane, const Found& found) const
  {
    const std::size_t l = searched_level();
    const T* const slack = slacks(l);
    for (std::size_t i = m_first_old; i < m_first_new; ++i) {
      const std::size_t f = m_minima[i];
      const T *below = numbers(l - 1, f), *same = numbers(l, f), *above = numbers(l + 1, f);
      for (std::size_t k = 1; k < last_lane; ++k) {
        const T lowered = same[k] - slack[k];
        if (!(lowered < -floor[k])) continue;
        const T* const earlier = numbers(l, f - 1);
        const T* const later = numbers(l, f + 1);
        if (lowered < earlier[k] && lowered < later[k] && lowered < same[k - 1] && lowered < same[k + 1] &&
            lowered < below[k] && lowered < above[k] && lowered < below[k - 1] && lowered < below[k + 1] &&
            lowered < above[k - 1] && lowered < above[k + 1])
          found(f, k);
      }
    }
  }

private:
  L* row(std::size_t l) { return m_levels[l % 3].data(); }
  T* slacks(std::size_t l) { return m_slacks.data() + l % 3 * L::size; }
  const T* slacks(std::size_t l) const { return m_slacks.data() + l % 3 * L::size; }
  const T* numbers(std::size_t l, std::size_t f) const
  {
    return reinterpret_cast<const T*>(m_levels[l % 3].data() + f);
  }

  std::size_t m_frames, m_first = 0, m_next = 0;
  std::vector<L> m_levels[3];
  std::vector<T> m_slacks; // [l % 3][lane]
  std::vector<std::size_t> m_minima; // frames of minima over time, of all levels so far
  std::size_t m_first_old = 0, m_first_new = 0; // in it, of the last level but one and of the last
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_RESPONSE_LANES_H
