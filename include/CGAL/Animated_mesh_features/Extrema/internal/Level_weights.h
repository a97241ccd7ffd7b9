// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_LEVEL_WEIGHTS_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_LEVEL_WEIGHTS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The weights of the two differences of a response at all levels, tabulated, and what is rounding beside them.
class Level_weights
{
public:
  // The share of the largest response that the weights allow, (|a| + |b|) max |d|, below which a response counts as
  // zero: a hundredth of the rounding of single precision, in which most animations come. Fields that are constant over
  // some frames or vertices have minima of rounding errors there.
  static constexpr double noise = 1. / (1 << 30);

  // For space levels [below, space_levels - above), time levels likewise. No response that is at most `least` counts.
  // `factors`, [vertex][space level], by which all responses are multiplied, is kept by reference; empty: all are 1.
  template <class Response>
  Level_weights(const Response& response, std::size_t space_levels, std::size_t time_levels, double largest_value,
                double least, const std::vector<float>& factors)
    : m_space_levels(space_levels)
    , m_time_levels(time_levels)
    , m_factors(&factors)
    , m_space(space_levels * time_levels, 0)
    , m_time(space_levels * time_levels, 0)
    , m_noise(noise * largest_value)
    , m_least(least)
  {
    for (std::size_t k = Response::below; k + Response::above < space_levels; ++k)
      for (std::size_t l = Response::below; l + Response::above < time_levels; ++l) {
        m_space[k * time_levels + l] = response.space_weight(k, l);
        m_time[k * time_levels + l] = response.time_weight(k, l);
      }
  }

  double space(std::size_t k, std::size_t l) const { return m_space[k * m_time_levels + l]; }
  double time(std::size_t k, std::size_t l) const { return m_time[k * m_time_levels + l]; }

  // By which the responses at a vertex are multiplied.
  bool has_factors() const { return !m_factors->empty(); }
  double factor(std::size_t v, std::size_t k) const
  {
    return has_factors() ? double((*m_factors)[v * m_space_levels + k]) : 1;
  }

  // A response that is not larger is no extremum.
  double floor(std::size_t k, std::size_t l) const
  {
    return (std::max)(m_least, m_noise * (std::abs(space(k, l)) + std::abs(time(k, l))));
  }

private:
  std::size_t m_space_levels, m_time_levels;
  const std::vector<float>* m_factors;
  std::vector<double> m_space, m_time; // [k][l]
  double m_noise, m_least;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_LEVEL_WEIGHTS_H
