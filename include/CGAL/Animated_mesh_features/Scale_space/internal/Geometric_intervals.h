// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_GEOMETRIC_INTERVALS_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_GEOMETRIC_INTERVALS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The derivative of a function F of ln x, known at nodes of a fixed ratio, as its logarithm and anywhere between the
// middles of the first and the last interval: an interpolation that keeps it positive.
class Geometric_intervals
{
public:
  // The middles are from `low` to `high`, with ratios of at most `largest_ratio`. 0 < low <= high.
  Geometric_intervals(double low, double high, double largest_ratio)
    : m_low(low)
    , m_step(std::log(largest_ratio))
  {
    const double span = std::log(high / low), rounding = 1e-9; // the same number in any unit
    if (span > rounding) {
      m_size += std::size_t(std::ceil(span / m_step - rounding));
      m_step = span / double(m_size - 1);
    }
  }

  // Number of intervals; there is one node more.
  std::size_t size() const { return m_size; }

  // Of ln x, from a node to the next.
  double step() const { return m_step; }

  double middle(std::size_t i) const { return m_low * std::exp(m_step * double(i)); }
  double node(std::size_t i) const { return m_low * std::exp(m_step * (double(i) - 0.5)); }

  // Replaces the logarithms l of F's difference quotients by those of its derivatives in the middles of the intervals. As
  // the quotient is F' + h^2 F''' / 24 + O(h^4), they differ by h^2 (l'^2 + l'') / 24: by 2 % for F ~ x^(1/2) and by 8 %
  // for F ~ x at a ratio of 4, of which 0.1 % remain.
  void to_derivatives(std::vector<double>& l) const
  {
    if (m_size == 1) return;
    double before = l[0], before_that = l[0];
    for (std::size_t i = 0; i < m_size; ++i) {
      const double now = l[i];
      double slope, bend = 0; // times h, times h^2
      if (i == 0)
        slope = l[1] - now;
      else if (i + 1 == m_size)
        slope = now - before;
      else
        slope = (l[i + 1] - before) / 2;
      if (i > 0 && i + 1 < m_size)
        bend = l[i + 1] - 2 * now + before;
      else if (m_size > 2)
        bend = i == 0 ? l[2] - 2 * l[1] + now : now - 2 * before + before_that;
      l[i] = now - (slope * slope + bend) / 24;
      before_that = before;
      before = now;
    }
  }

  // An interpolation in the middles of up to four neighbouring intervals.
  struct Weights
  {
    std::size_t first = 0, size = 0;
    double weight[4] = {};

    double operator()(const std::vector<double>& l) const
    {
      double sum = 0;
      for (std::size_t i = 0; i < size; ++i) sum += weight[i] * l[first + i];
      return sum;
    }
  };

  // For x by Lagrange's formula in ln x.
  Weights at(double x) const
  {
    Weights w;
    w.size = (std::min)(m_size, std::size_t(4));
    const double u = (std::max)(0., (std::min)(double(m_size - 1), std::log(x / m_low) / m_step));
    const double first = std::floor(u) - 1;
    w.first = std::size_t((std::max)(0., (std::min)(double(m_size - w.size), first)));
    for (std::size_t i = 0; i < w.size; ++i) {
      w.weight[i] = 1;
      for (std::size_t j = 0; j < w.size; ++j)
        if (j != i) w.weight[i] *= (u - double(w.first + j)) / (double(i) - double(j));
    }
    return w;
  }

private:
  double m_low, m_step;
  std::size_t m_size = 1;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_GEOMETRIC_INTERVALS_H
