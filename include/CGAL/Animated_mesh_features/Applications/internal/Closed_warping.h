// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_CLOSED_WARPING_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_CLOSED_WARPING_H

#include <CGAL/Animated_mesh_features/Applications/internal/Time_warping.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The best of `count` beginnings around a loop, by what each costs: every 32nd part of the loop, then halves of that step
// around the best one. Costs change little from a beginning to the next, as do motions.
template <class CostOf>
std::size_t best_beginning(std::size_t count, const CostOf& cost_of)
{
  const std::size_t parts = 32;
  std::size_t step = (std::max)(count / parts, std::size_t(1)), best = 0;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](std::size_t at) {
    const double cost = cost_of(at);
    if (cost < least) {
      least = cost;
      best = at;
    }
  };
  for (std::size_t at = 0; at < count; at += step) look(at);
  while (step > 1) {
    step = (step + 1) / 2;
    const std::size_t middle = best;
    look((middle + step) % count);
    look((middle + count - step) % count);
  }
  return best;
}

// Dynamic time warping of two loops of n and m samples: a closed way around both, by the steps of Time_warping, on which
// each sample of either side counts once. It is looked for from each pair in which the first sample of one of the loops
// is; see best_beginning(). O((n + m) or 80 times n m slope) time, whichever is less.
class Closed_warping
{
public:
  typedef Time_warping::Point Point;

  // cost(i, j) is asked once for each pair.
  template <class Cost>
  Closed_warping(std::size_t n, std::size_t m, const Cost& cost, std::size_t max_slope, double bend_cost)
    : m_n(n)
    , m_m(m)
    , m_max_slope(max_slope)
    , m_bend_cost(bend_cost)
    , m_costs(n * m)
  {
    for (std::size_t i = 0; i < n; ++i) {
      cancellation_point();
      for (std::size_t j = 0; j < m; ++j) m_costs[i * m + j] = float(cost(i, j));
    }
    const std::size_t of_b = best_beginning(m, [&](std::size_t j) { return cost_from(0, j); });
    const std::size_t of_a = best_beginning(n, [&](std::size_t i) { return cost_from(i, 0); });
    const double from_first_of_a = cost_from(0, of_b), from_first_of_b = cost_from(of_a, 0);
    m_cost = (std::min)(from_first_of_a, from_first_of_b);
    m_first = from_first_of_a <= from_first_of_b ? Point(0, of_b) : Point(of_a, 0);
    m_path = way_from(m_first.first, m_first.second).path();
    if (m_path.empty()) m_path = {Point(0, 0), Point(n, m)};
  }

  // the sum over all samples of both sides; infinite if the slope is too small for a closed way.
  double cost() const { return m_cost; }

  // the pair from which the way goes
  const Point& first() const { return m_first; }

  // the pairs of the way, counted from there, up to n and m, where the first one is again; these two alone
  // if there is no way.
  const std::vector<Point>& path() const { return m_path; }

private:
  double local(std::size_t i, std::size_t j) const { return double(m_costs[(i % m_n) * m_m + j % m_m]); }

  Time_warping way_from(std::size_t i, std::size_t j) const
  {
    return Time_warping(
        m_n + 1, m_m + 1, [&](std::size_t k, std::size_t l) { return local(i + k, j + l); }, m_max_slope, 1,
        m_bend_cost, Warping_ends::FIXED);
  }

  // the first pair is the last one, and counts as that
  double cost_from(std::size_t i, std::size_t j) const { return way_from(i, j).cost() - 2 * local(i, j); }

  std::size_t m_n, m_m, m_max_slope;
  double m_bend_cost, m_cost = 0;
  std::vector<float> m_costs;
  Point m_first;
  std::vector<Point> m_path;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_CLOSED_WARPING_H
