// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_TIME_DIFFERENCE_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_TIME_DIFFERENCE_H

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// How far two times are from each other: in a cyclic animation the shorter way round.
class Time_difference
{
public:
  // `period` in seconds; 0: the animation is not cyclic.
  explicit Time_difference(double period = 0)
    : m_period(period)
  {}

  double period() const { return m_period; }

  double operator()(double a, double b) const
  {
    const double difference = std::abs(a - b);
    return m_period > 0 ? (std::min)(difference, m_period - difference) : difference;
  }

private:
  double m_period;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_TIME_DIFFERENCE_H
