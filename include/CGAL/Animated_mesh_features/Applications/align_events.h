// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ALIGN_EVENTS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ALIGN_EVENTS_H

#include <CGAL/Animated_mesh_features/Applications/Time_alignment.h>
#include <CGAL/Animated_mesh_features/Descriptors/Described_features.h>
#include <CGAL/Animated_mesh_features/Descriptors/Matching_options.h>
#include <CGAL/Animated_mesh_features/Descriptors/feature_difference.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

What `align_events()` is told.
*/
struct Event_alignment_options
{
  Matching_options difference; ///< how unlike two events are: its weights, and how many of the strongest are looked at
  double accepted = 0.8;       ///< a pair of events of that difference neither gains nor costs anything
  double gap_opening = 0.4;    ///< what the first event costs that is skipped
  double gap_extension = 0.1;  ///< what each further one costs

  double begin_a = 0; ///< of a loop: the time at which the sequence of its events begins (s)
  double begin_b = 0; ///< the same of the second one

  /// looks whether all numbers are in their ranges.
  /// \throw Option_error if one is not.
  void check() const
  {
    difference.check();
    if (!(accepted > 0) || !(gap_opening >= 0) || !(gap_extension >= 0))
      throw Option_error("the costs of an alignment of events must not be negative");
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

Which events of two animations follow one another in the same order.
*/
struct Event_alignment
{
  std::vector<Feature_match> pairs; ///< in the order of time; the confidence is the gain over `accepted`, from 0 to 1
  std::vector<std::size_t> only_a;  ///< ranks of those that were looked at and have no partner, in the order of time
  std::vector<std::size_t> only_b;  ///< the same of the second animation
  double score = 0;                 ///< the sum of all gains less the costs of gaps
};

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

aligns the events of two animations as sequences: the local alignment of Smith and Waterman \cgalCite{smith1981} with
affine gaps (Gotoh \cgalCite{gotoh1982}). Events stand in the order of time. What happens at once, within half of its
\f$\tau\f$, is ordered by the place on the body, from the middle outward, which is the same in both.

`O(A B)` time and memory for `A` and `B` events.

\param a, b the events.
\param options costs.
\throw Option_error if an option is out of its range; Cancelled as `align_animations()`.
*/
Event_alignment align_events(const Described_features& a, const Described_features& b,
                             const Event_alignment_options& options = Event_alignment_options());

namespace internal {

// In the order of time, in a loop from `begin` on; neighbours that overlap, in that of how far out they are.
inline std::vector<std::size_t> events_in_order(const Described_features& d, std::size_t top, double begin)
{
  std::vector<std::size_t> order = strongest_features(d.features, top);
  const auto time_of = [&](std::size_t i) {
    const double time = d.features[i].time;
    return d.loop > 0 ? time - begin - std::floor((time - begin) / d.loop) * d.loop : time;
  };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return std::make_pair(time_of(i), i) < std::make_pair(time_of(j), j);
  });
  const auto inward = [&](std::size_t i) { // the surface nearby and far away
    double sum = 0;
    if (i < d.places.size())
      for (std::size_t k = 0; k < d.places.length(); ++k) sum += double(d.places[i][k]);
    return sum;
  };
  for (std::size_t i = 0; i < order.size();) {
    const double last = time_of(order[i]) + d.features[order[i]].tau / 2;
    std::size_t end = i + 1;
    while (end < order.size() && time_of(order[end]) <= last) ++end;
    std::stable_sort(order.begin() + std::ptrdiff_t(i), order.begin() + std::ptrdiff_t(end),
                     [&](std::size_t x, std::size_t y) { return inward(x) > inward(y); });
    i = end;
  }
  return order;
}

} // namespace internal

inline Event_alignment align_events(const Described_features& a, const Described_features& b,
                                    const Event_alignment_options& o)
{
  o.check();
  const std::vector<std::size_t> x = internal::events_in_order(a, o.difference.top, o.begin_a);
  const std::vector<std::size_t> y = internal::events_in_order(b, o.difference.top, o.begin_b);
  const std::size_t n = x.size(), m = y.size(), width = m + 1;
  // states: a pair, an event of a without partner, one of b; where each came from
  enum State : unsigned char
  {
    PAIR,
    SKIP_A,
    SKIP_B,
    START
  };
  std::vector<double> best[3];
  std::vector<unsigned char> from[3];
  for (int s = 0; s < 3; ++s) {
    best[s].assign((n + 1) * width, s == PAIR ? 0. : -1e300);
    from[s].assign((n + 1) * width, START);
  }
  std::vector<double> differences(n * m);
  Event_alignment result;
  std::size_t end_i = 0, end_j = 0;
  for (std::size_t i = 1; i <= n; ++i) {
    internal::cancellation_point();
    for (std::size_t j = 1; j <= m; ++j) {
      const std::size_t at = i * width + j, diagonal = at - width - 1;
      const auto skip = [&](State s, std::size_t before) {
        const double opened = best[PAIR][before] - o.gap_opening, extended = best[s][before] - o.gap_extension;
        best[s][at] = (std::max)(opened, extended);
        from[s][at] = extended > opened ? s : PAIR;
      };
      skip(SKIP_A, at - width);
      skip(SKIP_B, at - 1);
      const double difference = feature_difference(a, x[i - 1], b, y[j - 1], o.difference);
      differences[(i - 1) * m + j - 1] = difference;
      double before = 0;
      unsigned char state = START;
      for (unsigned char s : {PAIR, SKIP_A, SKIP_B})
        if (best[s][diagonal] > before) {
          before = best[s][diagonal];
          state = s;
        }
      best[PAIR][at] = before + 1 - difference / o.accepted;
      from[PAIR][at] = state;
      if (best[PAIR][at] > result.score) {
        result.score = best[PAIR][at];
        end_i = i;
        end_j = j;
      }
    }
  }
  std::vector<char> of_a(n, 0), of_b(m, 0);
  for (unsigned char state = result.score > 0 ? PAIR : START; state != START;) {
    const unsigned char next = from[state][end_i * width + end_j];
    if (state == PAIR) {
      const double difference = differences[(end_i - 1) * m + end_j - 1];
      // pairs that cost more than they gain are but a bridge
      if (difference <= o.accepted) {
        result.pairs.push_back({x[end_i - 1], y[end_j - 1], 1 - difference / o.accepted, difference});
        of_a[end_i - 1] = of_b[end_j - 1] = 1;
      }
      --end_i;
      --end_j;
    } else if (state == SKIP_A) {
      --end_i;
    } else {
      --end_j;
    }
    state = next;
  }
  std::reverse(result.pairs.begin(), result.pairs.end());
  for (std::size_t i = 0; i < n; ++i)
    if (of_a[i] == 0) result.only_a.push_back(x[i]);
  for (std::size_t j = 0; j < m; ++j)
    if (of_b[j] == 0) result.only_b.push_back(y[j]);
  return result;
}

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

the same of animations that are aligned: a loop's sequence begins where the other animation does.
*/
inline Event_alignment align_events(const Described_features& a, const Described_features& b,
                                    const Time_alignment& alignment, Event_alignment_options options = {})
{
  if (b.loop > 0)
    options.begin_b = alignment.to_b(options.begin_a);
  else if (a.loop > 0)
    options.begin_a = alignment.to_a(0);
  return align_events(a, b, options);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ALIGN_EVENTS_H
