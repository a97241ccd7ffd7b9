// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_JOIN_EQUAL_EXTREMA_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_JOIN_EQUAL_EXTREMA_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Extremum.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Time_axis.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Equal or nearly equal extrema that are joined by a path of nearly equal response are one event: a ring that swells all
// around has as many of them as rounding and the sampling of the surface choose. The saddle between them decides: an
// extremum joins a stronger one of its space level, at most one time level and one frame away, if the vertices on a path
// between the two have responses, at scale and frame of the stronger one, that are above this share of it.
constexpr double saddle_share = 0.95;

// Whether a search wants that: those that do not say do not.
template <class Search>
auto joins_equal(const Search& search, int) -> decltype(bool(search.join_equal))
{
  return search.join_equal;
}
template <class Search>
bool joins_equal(const Search&, long)
{
  return false;
}
template <class Search>
bool joins_equal(const Search& search)
{
  return joins_equal(search, 0);
}

// Responses that differ by less are equal up to rounding; the place decides then.
constexpr double tie_tolerance = 1e-6;

// The order of vertices that does not depend on how they are numbered.
inline bool precedes(const Rest_shape& shape, std::size_t v, std::size_t w)
{
  const Rest_shape::Point &p = shape.points()[v], &q = shape.points()[w];
  return std::make_tuple(p[0], p[1], p[2], v) < std::make_tuple(q[0], q[1], q[2], w);
}

// Which extrema may be joined, by scale and frame alone: for each of them the others. Of one space level, so that the
// result does not depend on which levels are in memory at a time.
class Extrema_of_like_scale
{
public:
  Extrema_of_like_scale(const std::vector<Extremum>& extrema, const Time_axis& time)
    : m_extrema(extrema)
    , m_time(time)
    , m_order(extrema.size())
  {
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::sort(m_order.begin(), m_order.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  }

  // visit(j) for each that may be joined with i, i among them.
  template <class Visit>
  void for_each(std::size_t i, const Visit& visit) const
  {
    const Extremum& e = m_extrema[i];
    const std::size_t before = m_time.before(e.frame), after = m_time.after(e.frame);
    for (std::size_t l = e.l - 1; l <= e.l + 1; ++l) {
      const std::size_t last = (std::max)(after, e.frame);
      visit_frames(e.k, l, (std::min)(before, e.frame), last, visit);
      if (before > e.frame) visit_frames(e.k, l, before, before, visit); // beyond the end that is joined
      if (after < e.frame) visit_frames(e.k, l, after, after, visit);
    }
  }

  // Whether there is one that is nearly as strong as i, or a bit stronger.
  bool has_equal(std::size_t i) const
  {
    bool result = false;
    for_each(i, [&](std::size_t j) {
      const double ratio = m_extrema[j].response() / m_extrema[i].response();
      result = result || (j != i && ratio >= saddle_share && ratio * saddle_share <= 1);
    });
    return result;
  }

private:
  typedef std::tuple<std::size_t, std::size_t, std::size_t, std::size_t> Key; // space level, time level, frame, index
  Key key(std::size_t i) const { return Key(m_extrema[i].k, m_extrema[i].l, m_extrema[i].frame, i); }

  // visit(j) for each extremum of these levels in frames [first, last].
  template <class Visit>
  void visit_frames(std::size_t k, std::size_t l, std::size_t first, std::size_t last, const Visit& visit) const
  {
    auto it = std::lower_bound(m_order.begin(), m_order.end(), Key(k, l, first, 0),
                               [&](std::size_t j, const Key& other) { return key(j) < other; });
    for (; it != m_order.end() && m_extrema[*it].k == k && m_extrema[*it].l == l && m_extrema[*it].frame <= last; ++it)
      visit(*it);
  }

  const std::vector<Extremum>& m_extrema;
  const Time_axis m_time;
  std::vector<std::size_t> m_order;
};

// The vertices that an extremum reaches on paths above its saddle; `response(v)` is that at its scale and frame.
template <class Response>
std::vector<Rest_shape::Index> reached_from(const Rest_shape& shape, const Extremum& e, const Response& response)
{
  const double highest = saddle_share * e.response(); // responses are negative
  std::vector<Rest_shape::Index> reached = {e.vertex};
  std::unordered_set<Rest_shape::Index> seen = {e.vertex};
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (Rest_shape::Index w : shape.neighbours()[reached[i]])
      if (seen.insert(w).second && response(w) < highest) reached.push_back(w);
  std::sort(reached.begin(), reached.end());
  return reached;
}

// Leaves one of each set of extrema that belong together: the strongest, of equals the one whose place precedes.
// `reached`: for each extremum that has equals, the vertices that it reaches.
inline void join_equal_extrema(const Rest_shape& shape, const Extrema_of_like_scale& like,
                               const std::vector<std::vector<Rest_shape::Index>>& reached, std::vector<Extremum>& extrema)
{
  std::vector<std::size_t> order(extrema.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    const Extremum &a = extrema[i], &b = extrema[j];
    if (a.response() != b.response()) return a.response() < b.response();
    return a.vertex != b.vertex ? precedes(shape, a.vertex, b.vertex) : i < j;
  });
  std::vector<char> dropped(extrema.size(), 0), done(extrema.size(), 0);
  for (std::size_t i : order) {
    done[i] = 1;
    if (dropped[i] || reached[i].empty()) continue;
    std::size_t best = i;
    like.for_each(i, [&](std::size_t j) {
      if (done[j] || dropped[j] || !std::binary_search(reached[i].begin(), reached[i].end(), extrema[j].vertex)) return;
      const bool is_tie = extrema[j].response() <= extrema[i].response() * (1 - tie_tolerance);
      if (is_tie && precedes(shape, extrema[j].vertex, extrema[best].vertex)) {
        dropped[best] = 1;
        best = j;
      } else
        dropped[j] = 1;
    });
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < extrema.size(); ++i)
    if (!dropped[i]) {
      if (kept != i) extrema[kept] = std::move(extrema[i]);
      ++kept;
    }
  extrema.resize(kept);
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_JOIN_EQUAL_EXTREMA_H
