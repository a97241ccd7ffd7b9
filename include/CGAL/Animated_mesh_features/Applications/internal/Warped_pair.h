// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_WARPED_PAIR_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_WARPED_PAIR_H

#include <CGAL/Animated_mesh_features/Applications/Activity.h>
#include <CGAL/Animated_mesh_features/Applications/Alignment_options.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Activity_cost.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Closed_warping.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Time_refinement.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Time_warping.h>
#include <CGAL/Animated_mesh_features/Applications/internal/played_loop.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The warping of two activities. Two that end: by Time_warping. Two loops, each played as often as makes their durations
// most alike: by Closed_warping. One that ends and a loop, which is the second: the loop from where it fits best.
class Warped_pair
{
public:
  typedef Time_warping::Point Point;

  // Arguments are kept by reference.
  Warped_pair(const Activity& a, const Activity& b, const Alignment_options& options)
    : m_a(a)
    , m_b(b)
    , m_options(options)
    , m_cost(a, b, options)
    , m_n(a.samples * number_of_plays(a, b))
    , m_m(b.samples * number_of_plays(b, a) + (b.is_cyclic && !a.is_cyclic ? 1 : 0))
    , m_bend_cost(options.bend_weight * m_cost.mean_norm())
  {}

  struct Way
  {
    double cost;             // relative, see Activity_cost
    Point first;             // where both are begun
    std::vector<Point> path; // from there on
  };

  // `of_b(j)` is the sample that stands at the j-th one of the second activity.
  template <class Order>
  Way way(const Order& of_b) const
  {
    const auto cost = [&](std::size_t i, std::size_t j) {
      return m_b.is_cyclic ? m_cost.between_samples(i % m_a.samples, of_b(j % m_b.samples)) : m_cost(i, of_b(j));
    };
    if (m_a.is_cyclic) {
      const Closed_warping warping(m_n, m_m, cost, m_options.max_slope, m_bend_cost);
      return way_of(warping, warping.first());
    }
    const auto from = [&](std::size_t first) {
      return Time_warping(
          m_n, m_m, [&](std::size_t i, std::size_t j) { return cost(i, first + j); }, m_options.max_slope,
          m_options.end_weight, m_bend_cost);
    };
    if (!m_b.is_cyclic) return way_of(from(0), Point(0, 0));
    const std::size_t first = best_beginning(m_b.samples, [&](std::size_t s) { return from(s).cost(); });
    return way_of(from(first), Point(0, first));
  }

  // The smooth map that is made of a way, in samples.
  std::vector<std::pair<double, double>> smooth(const Way& way) const
  {
    std::vector<std::pair<double, double>> result;
    const double smoothing = m_options.smoothing / m_a.sample_duration;
    const double x = double(way.first.first), y = double(way.first.second), n = double(m_n), m = double(m_m);
    if (!m_a.is_cyclic) {
      const Time_refinement map(cost_of(way.first, m_n, m_m), way.path, smoothing, m_options.max_slope);
      for (std::size_t k = 0; k < map.size(); ++k) result.emplace_back(map.a(k), y + map.b(k));
      return result;
    }
    // played three times, so that the second time has no ends
    const std::size_t times = 3;
    std::vector<Point> path = {way.path.front()};
    for (std::size_t t = 0; t < times; ++t)
      for (std::size_t k = 1; k < way.path.size(); ++k)
        path.emplace_back(way.path[k].first + t * m_n, way.path[k].second + t * m_m);
    const Time_refinement map(cost_of(way.first, times * m_n + 1, times * m_m + 1), path, smoothing,
                              m_options.max_slope);
    for (std::size_t k = 0; k < map.size(); ++k)
      if (map.a(k) >= n && map.a(k) < 2 * n) result.emplace_back(x + map.a(k) - n, y + map.b(k) - m);
    const std::pair<double, double> again(result.front().first + n, result.front().second + m);
    while (result.size() > 1 && !(result.back().first < again.first && result.back().second < again.second))
      result.pop_back();
    result.push_back(again);
    return result;
  }

private:
  template <class Warping>
  Way way_of(const Warping& warping, const Point& first) const
  {
    // all samples of both loops count, in the same order wherever the way begins
    const Activity_cost cost = cost_of(m_a.is_cyclic ? Point(0, 0) : first, m_n, m_m);
    return {cost.relative(warping.cost()), first, warping.path()};
  }

  // of so many samples from there on, for which a loop is played
  Activity_cost cost_of(const Point& first, std::size_t n, std::size_t m) const
  {
    if (!m_b.is_cyclic) return m_cost;
    return Activity_cost(m_a.is_cyclic ? played_loop(m_a, first.first, n) : m_a, played_loop(m_b, first.second, m),
                         m_options);
  }

  const Activity &m_a, &m_b;
  const Alignment_options& m_options;
  Activity_cost m_cost;
  std::size_t m_n, m_m;
  double m_bend_cost;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_WARPED_PAIR_H
