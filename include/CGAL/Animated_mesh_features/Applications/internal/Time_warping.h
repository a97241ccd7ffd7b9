// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TIME_WARPING_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TIME_WARPING_H

#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Where a way begins and ends: anywhere on the edges, samples without partner costing something; or at the first samples
// of both, and at the last ones.
enum class Warping_ends
{
  OPEN,
  FIXED
};

// Dynamic time warping of n against m samples (Sakoe and Chiba 1978) in steps of (1, 1), (1, q) and (q, 1), q up to the
// largest slope; each sample of either side counts once. Samples that have no partner at the beginning and at the end
// are compared with the first or last one of the other side, and count by `end_weight`. A step of (1, q) or (q, 1) costs
// `bend_cost` q - 1 times, so that clocks run alike where nothing says that they do not. O(n m slope) time, 5 n m bytes.
class Time_warping
{
public:
  typedef std::pair<std::size_t, std::size_t> Point;

  // cost(i, j) is asked once for each pair.
  template <class Cost>
  Time_warping(std::size_t n, std::size_t m, const Cost& cost, std::size_t max_slope, double end_weight,
               double bend_cost, Warping_ends ends = Warping_ends::OPEN)
    : m_m(m)
    , m_has_fixed_ends(ends == Warping_ends::FIXED)
    , m_end_weight(end_weight)
    , m_bend_cost(bend_cost)
    , m_costs(n * m)
    , m_steps(n * m, 0)
  {
    for (std::size_t i = 0; i < n; ++i) {
      cancellation_point();
      for (std::size_t j = 0; j < m; ++j) m_costs[i * m + j] = float(cost(i, j));
    }
    accumulate(n, max_slope);
    finish(n);
  }

  // the sum over all samples of both sides
  double cost() const { return m_cost; }

  // the pairs of the way, without ends that have no partner
  const std::vector<Point>& path() const { return m_path; }

private:
  double local(std::size_t i, std::size_t j) const { return double(m_costs[i * m_m + j]); }

  // Steps are 0 for a beginning, q for (1, q), 128 + q for (q, 1). Of two ways of the same cost it is the more even
  // one.
  void accumulate(std::size_t n, std::size_t max_slope)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    const std::size_t kept = max_slope + 1; // rows that are looked back at
    std::vector<std::vector<double>> rows(kept, std::vector<double>(m_m, infinity));
    m_last_column.assign(n, infinity);
    double start = 0; // of this row in the first column
    for (std::size_t i = 0; i < n; ++i) {
      cancellation_point();
      std::vector<double>& row = rows[i % kept];
      const auto above = [&](std::size_t q) -> const std::vector<double>& { return rows[(i - q) % kept]; };
      start += (i == 0 ? 2 : m_end_weight) * local(i, 0);
      row[0] = i > 0 && m_has_fixed_ends ? infinity : start;
      for (std::size_t j = 1; j < m_m; ++j) {
        if (i == 0) {
          row[j] = m_has_fixed_ends ? infinity : row[j - 1] + m_end_weight * local(0, j);
          continue;
        }
        double best = above(1)[j - 1] + 2 * local(i, j);
        std::uint8_t step = 1;
        double passed = local(i, j); // of the cells after the first one
        for (std::size_t q = 2; q <= (std::min)(max_slope, j); ++q) {
          const double sum = above(1)[j - q] + 2 * local(i, j - q + 1) + passed + double(q - 1) * m_bend_cost;
          passed += local(i, j - q + 1);
          if (sum < best) {
            best = sum;
            step = std::uint8_t(q);
          }
        }
        passed = local(i, j);
        for (std::size_t q = 2; q <= (std::min)(max_slope, i); ++q) {
          const double sum = above(q)[j - 1] + 2 * local(i - q + 1, j) + passed + double(q - 1) * m_bend_cost;
          passed += local(i - q + 1, j);
          if (sum < best) {
            best = sum;
            step = std::uint8_t(128 + q);
          }
        }
        row[j] = best;
        m_steps[i * m_m + j] = step;
      }
      m_last_column[i] = row[m_m - 1];
      if (i + 1 == n) m_last_row = row;
    }
  }

  void finish(std::size_t n)
  {
    m_cost = m_last_row[m_m - 1];
    Point end(n - 1, m_m - 1);
    if (!m_has_fixed_ends) leave_out_ends(n, end);
    if (!(m_cost < (std::numeric_limits<double>::infinity)())) return; // the slope is too small to get there
    for (;;) {
      m_path.push_back(end);
      const std::uint8_t step = m_steps[end.first * m_m + end.second];
      if (step == 0) break;
      if (step < 128) {
        end.first -= 1;
        end.second -= step;
      } else {
        end.first -= std::size_t(step - 128);
        end.second -= 1;
      }
    }
    std::reverse(m_path.begin(), m_path.end());
  }

  void leave_out_ends(std::size_t n, Point& end)
  {
    double rest = 0;
    for (std::size_t j = m_m - 1; j-- > 0;) {
      rest += m_end_weight * local(n - 1, j + 1);
      if (m_last_row[j] + rest < m_cost) {
        m_cost = m_last_row[j] + rest;
        end = {n - 1, j};
      }
    }
    rest = 0;
    for (std::size_t i = n - 1; i-- > 0;) {
      rest += m_end_weight * local(i + 1, m_m - 1);
      if (m_last_column[i] + rest < m_cost) {
        m_cost = m_last_column[i] + rest;
        end = {i, m_m - 1};
      }
    }
  }

  std::size_t m_m;
  bool m_has_fixed_ends;
  double m_end_weight, m_bend_cost, m_cost = 0;
  std::vector<float> m_costs;
  std::vector<std::uint8_t> m_steps;
  std::vector<double> m_last_row, m_last_column;
  std::vector<Point> m_path;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TIME_WARPING_H
