// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_PACKED_RESPONSES_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_PACKED_RESPONSES_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Sign_mask.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The responses of one vertex at three successive time levels, in packs with an entry for each space level, and the
// search for minima among them. Time levels are pushed in ascending order; a level is searched when the next one has
// come.
//
// Most of the work is rejecting: of all samples only the minima over time, a few frames of a level, are compared with
// their neighbours in scale.
template <class Response_pack>
class Packed_responses
{
public:
  typedef typename Response_pack::Scalar T;

  explicit Packed_responses(std::size_t number_of_frames)
    : m_frames(number_of_frames)
    , m_minima((number_of_frames - 2 + History::size - 1) / History::size)
    , m_new_minima(m_minima.size())
    , m_slacks(3, Response_pack::all(0))
  {
    for (std::vector<Response_pack>& level : m_levels) level.assign(number_of_frames, Response_pack::all(0));
  }

  // What comes next is time level `first` of another vertex.
  void start(std::size_t first) { m_next = m_first = first; }

  // Pushes a level: response(f) for each frame, of which two may differ by `slack` more than they seem to.
  template <class Response>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void push(const Response_pack& slack, const Response_pack& floor,
                                               const Response& response)
  {
    Response_pack* const d = row(m_next);
    m_slacks[m_next % 3] = slack;
    m_minima.swap(m_new_minima);
    const Response_pack bound = slack - floor;
    Response_pack before = response(0), now = response(1);
    d[0] = before;
    d[1] = now;
    // Whether frame f has a minimum over time is known when f + 1 has come, and written down without a question: which
    // frames have one no processor can foresee.
    for (std::size_t part = 0; part < m_new_minima.size(); ++part) {
      const std::size_t first = first_frame(part), frames = number_of_frames(part);
      History history;
      const auto step = [&](std::size_t f) CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA {
        const Response_pack next = response(f + 1);
        d[f + 1] = next;
        const Response_pack lowered = now - slack;
        history.push(negative(lowered - before) & negative(lowered - next) & negative(now - bound));
        before = now;
        now = next;
      };
      std::size_t f = first;
      for (; f + 2 <= first + frames; f += 2) {
        step(f);
        step(f + 1);
      }
      if (f < first + frames) step(f);
      m_new_minima[part] = history;
    }
    ++m_next;
  }

  // Whether there is a level with one on either side: the last but one that was pushed.
  bool can_search() const { return m_next >= m_first + 3; }
  std::size_t searched_level() const { return m_next - 2; }

  // found(frame, entry) for each minimum of that level among the entries [1, last_entry) of the packs.
  template <class Found>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void search(std::size_t last_entry, const Found& found) const
  {
    const std::size_t l = searched_level();
    const Response_pack slack = m_slacks[l % 3];
    for (std::size_t part = 0; part < m_minima.size(); ++part) {
      const History& minima = m_minima[part];
      const std::size_t unused = History::size - number_of_frames(part); // bits, the lowest
      typename History::Integer any = minima.any() >> unused;
      for (std::size_t i = 0; any != 0; any >>= 1, ++i) {
        if ((any & 1) == 0) continue;
        const std::size_t f = first_frame(part) + i;
        const T *below = numbers(l - 1, f), *same = numbers(l, f), *above = numbers(l + 1, f);
        const Response_pack lowered = Response_pack::load(same) - slack;
        const auto lower_than = [&](const T* other) CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA {
          return negative(lowered - Response_pack::load(other));
        };
        const History found_here =
            minima.that_have(unused + i, lower_than(same - 1) & lower_than(same + 1) & lower_than(below) &
                                             lower_than(above) & lower_than(below - 1) & lower_than(below + 1) &
                                             lower_than(above - 1) & lower_than(above + 1));
        if (found_here.any() == 0) continue;
        typename History::Integer is_minimum[Response_pack::size];
        found_here.store(is_minimum);
        for (std::size_t k = 1; k < last_entry; ++k)
          if (is_minimum[k] != 0) found(f, k);
      }
    }
  }

private:
  typedef Sign_history<T, Response_pack::size, sizeof(typename Response_pack::Register_type)> History;

  // Frames are written down in parts of as many as a history has bits, those that have a frame on either side.
  static std::size_t first_frame(std::size_t part) { return 1 + part * History::size; }
  std::size_t number_of_frames(std::size_t part) const
  {
    return (std::min)(m_frames - 1 - first_frame(part), History::size);
  }

  Response_pack* row(std::size_t l) { return m_levels[l % 3].data(); }
  const T* numbers(std::size_t l, std::size_t f) const
  {
    return reinterpret_cast<const T*>(m_levels[l % 3].data() + f);
  }

  std::size_t m_frames, m_first = 0, m_next = 0;
  std::vector<Response_pack> m_levels[3];
  std::vector<History> m_minima, m_new_minima; // over time, of the last level but one and of the last: [part]
  std::vector<Response_pack> m_slacks;         // [l % 3]
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_PACKED_RESPONSES_H
