// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TIME_REFINEMENT_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TIME_REFINEMENT_H

#include <CGAL/Animated_mesh_features/Applications/internal/Activity_cost.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Time_warping.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Vector_sequence.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Makes a smooth map of the way of a dynamic time warping: the registration of two curves (Ramsay and Li 1998). Over the
// middle of both times, s = (a + b) / 2, the offset d(s) = b - a minimises
//
//   sum |x(s - d / 2) - y(s + d / 2)|^2 + l^4 m sum d''^2,
//
// where x and y are the vectors of both activities, without the recurrence, and m is the mean square of their
// derivatives: bends within less than l samples count more than what moves. Neither animation comes first. Where nothing
// moves d is the curve that bends least between what moves before and after. If both are still at their beginnings, or
// ends, for times whose ratio the slope allows, these belong together.
//
// The root mean square of a group of numbers over an animation depends on how long what is held, so that a warp
// changes it: here groups have equal root mean squares over what belongs together. Gauss-Newton steps, that are halved
// until the sum falls; O(samples) each. Samples are counted, not seconds.
class Time_refinement
{
public:
  Time_refinement(const Activity_cost& cost, const std::vector<Time_warping::Point>& path, double smoothing,
                  std::size_t max_slope)
    : m_x(cost.instants_of_a())
    , m_y(cost.instants_of_b())
    , m_max_slope(double(max_slope))
  {
    m_motion = (m_x.mean_square_derivative() + m_y.mean_square_derivative()) / 2;
    begin_at(path);
    m_bend = std::pow(smoothing, 4) * m_motion / std::pow(m_step, 3);
    if (m_motion > 0 && m_offsets.size() > 2)
      for (int k = 0; k < 20; ++k) {
        equalise(cost.groups_of_instants());
        if (descend() < 0.01) break;
      }
  }

  std::size_t size() const { return m_offsets.size(); }
  double a(std::size_t k) const { return middle(k) - m_offsets[k] / 2; }
  double b(std::size_t k) const { return middle(k) + m_offsets[k] / 2; }

private:
  double middle(std::size_t k) const { return m_first + double(k) * m_step; }

  void begin_at(const std::vector<Time_warping::Point>& path)
  {
    std::vector<std::pair<double, double>> points; // the middle of both times, the offset
    const auto add = [&](double a, double b) { points.emplace_back((a + b) / 2, b - a); };
    const double last_a = double(m_x.size() - 1), last_b = double(m_y.size() - 1);
    const auto [a0, b0] = path.front();
    const auto [a1, b1] = path.back();
    const auto belong_together = [&](double still_a, double still_b) {
      return (std::max)(still_a, still_b) <= m_max_slope * (std::min)(still_a, still_b);
    };
    const std::pair<double, double> x = moving(m_x), y = moving(m_y);
    m_is_begin_fixed = double(a0) <= x.first && double(b0) <= y.first && belong_together(x.first, y.first);
    m_is_end_fixed =
        double(a1) >= x.second && double(b1) >= y.second && belong_together(last_a - x.second, last_b - y.second);
    if (m_is_begin_fixed && a0 + b0 > 0) add(0, 0);
    for (const auto& [a, b] : path) add(double(a), double(b));
    if (m_is_end_fixed && double(a1 + b1) < last_a + last_b) add(last_a, last_b);
    m_first = points.front().first;
    const double length = points.back().first - m_first;
    m_offsets.resize(std::size_t(std::lround(length)) + 1);
    m_step = m_offsets.size() > 1 ? length / double(m_offsets.size() - 1) : 1;
    for (std::size_t k = 0, i = 1; k < m_offsets.size(); ++k) {
      while (i + 1 < points.size() && points[i].first < middle(k)) ++i;
      if (points.size() == 1) {
        m_offsets[k] = points[0].second;
        continue;
      }
      const auto& [s, d] = points[i - 1];
      const auto& [t, e] = points[i];
      m_offsets[k] = d + (e - d) * (std::min)((std::max)((middle(k) - s) / (t - s), 0.), 1.);
    }
    m_begin = m_offsets.front();
    m_end = m_offsets.back();
    limit_slope(m_offsets);
  }

  // the first and the last sample at which something moves, of a thousandth of the mean square
  std::pair<double, double> moving(const Vector_sequence& x) const
  {
    std::size_t first = 0, last = x.size() - 1;
    const auto is_still = [&](std::size_t t) { return !(x.square_derivative(t) > 1e-3 * m_motion); };
    while (first < last && is_still(first)) ++first;
    while (last > first && is_still(last)) --last;
    return {double(first), double(last)};
  }

  void equalise(const std::vector<std::size_t>& groups)
  {
    std::size_t begin = 0;
    for (std::size_t width : groups) {
      double squares_x = 0, squares_y = 0;
      for (std::size_t k = 0; k < size(); ++k)
        for (std::size_t c = begin; c < begin + width; ++c) {
          squares_x += std::pow(m_x.value(a(k), c), 2);
          squares_y += std::pow(m_y.value(b(k), c), 2);
        }
      if (squares_x > 0 && squares_y > 0) {
        const double root = std::pow(squares_x / squares_y, 0.25);
        m_x.scale(begin, begin + width, 1 / root);
        m_y.scale(begin, begin + width, root);
      }
      begin += width;
    }
  }

  double energy(const std::vector<double>& d) const
  {
    double sum = 0;
    for (std::size_t k = 0; k < d.size(); ++k)
      for (std::size_t c = 0; c < m_x.width(); ++c)
        sum += m_step * std::pow(m_x.value(middle(k) - d[k] / 2, c) - m_y.value(middle(k) + d[k] / 2, c), 2);
    for (std::size_t k = 1; k + 1 < d.size(); ++k) sum += m_bend * std::pow(d[k - 1] - 2 * d[k] + d[k + 1], 2);
    return sum;
  }

  // returns the largest change of an offset.
  double descend()
  {
    const std::size_t n = size();
    // the normal equations: a matrix of bandwidth 2, by its rows from the diagonal
    std::vector<double> diagonal(n, 0), next(n, 0), after(n, 0), right(n, 0);
    const double held = 1e-9 * m_motion, fixed = 1e3 * m_motion;
    for (std::size_t k = 0; k < n; ++k) {
      double squares = 0, products = 0;
      for (std::size_t c = 0; c < m_x.width(); ++c) {
        const double slope = -(m_x.derivative(a(k), c) + m_y.derivative(b(k), c)) / 2;
        squares += slope * slope;
        products += slope * (m_x.value(a(k), c) - m_y.value(b(k), c));
      }
      diagonal[k] = m_step * squares + held;
      right[k] = diagonal[k] * m_offsets[k] - m_step * products;
    }
    const auto fix = [&](std::size_t k, double offset) {
      diagonal[k] += fixed;
      right[k] += fixed * offset;
    };
    if (m_is_begin_fixed) fix(0, m_begin);
    if (m_is_end_fixed) fix(n - 1, m_end);
    for (std::size_t k = 1; k + 1 < n; ++k) {
      diagonal[k - 1] += m_bend;
      diagonal[k] += 4 * m_bend;
      diagonal[k + 1] += m_bend;
      next[k - 1] -= 2 * m_bend;
      next[k] -= 2 * m_bend;
      after[k - 1] += m_bend;
    }
    solve(diagonal, next, after, right);
    if (m_is_begin_fixed) right.front() = m_begin; // to the last bit
    if (m_is_end_fixed) right.back() = m_end;
    const double before = energy(m_offsets);
    for (double length = 1; length > 0.05; length /= 2) {
      std::vector<double> d(n);
      for (std::size_t k = 0; k < n; ++k) d[k] = m_offsets[k] + length * (right[k] - m_offsets[k]);
      limit_slope(d);
      if (energy(d) > before) continue;
      double change = 0;
      for (std::size_t k = 0; k < n; ++k) change = (std::max)(change, std::abs(d[k] - m_offsets[k]));
      m_offsets.swap(d);
      return change;
    }
    return 0;
  }

  // L D L^T of a positive definite matrix of bandwidth 2; the solution takes the place of the right hand side.
  static void solve(std::vector<double>& diagonal, std::vector<double>& next, std::vector<double>& after,
                    std::vector<double>& x)
  {
    const std::size_t n = x.size();
    for (std::size_t k = 0; k < n; ++k) {
      const double first = next[k] / diagonal[k], second = after[k] / diagonal[k];
      if (k + 1 < n) {
        diagonal[k + 1] -= first * next[k];
        next[k + 1] -= first * after[k];
        x[k + 1] -= first * x[k];
      }
      if (k + 2 < n) {
        diagonal[k + 2] -= second * after[k];
        x[k + 2] -= second * x[k];
      }
      next[k] = first;
      after[k] = second;
    }
    for (std::size_t k = n; k-- > 0;) {
      x[k] /= diagonal[k];
      if (k + 1 < n) x[k] -= next[k] * x[k + 1];
      if (k + 2 < n) x[k] -= after[k] * x[k + 2];
    }
  }

  // A slope q of b over a is one of 2 (q - 1) / (q + 1) of d over s.
  void limit_slope(std::vector<double>& d) const
  {
    const double most = 2 * (m_max_slope - 1) / (m_max_slope + 1) * m_step;
    for (std::size_t k = 1; k < d.size(); ++k) d[k] = (std::min)((std::max)(d[k], d[k - 1] - most), d[k - 1] + most);
  }

  Vector_sequence m_x, m_y;
  double m_max_slope, m_motion = 0, m_bend = 0;
  double m_first = 0, m_step = 1, m_begin = 0, m_end = 0;
  bool m_is_begin_fixed = false, m_is_end_fixed = false;
  std::vector<double> m_offsets;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TIME_REFINEMENT_H
