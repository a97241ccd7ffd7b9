// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_FEATURE_PRESENCE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_FEATURE_PRESENCE_H

#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// What is to be seen of a feature, all in all. A response that knows of no amplitude leaves the strength.
inline double worth(const Feature_point& f)
{
  return f.amplitude > 0 ? f.amplitude : f.strength > 0 ? f.strength : 0;
}

// The frames in which a feature lives, within 2 tau of its time, and what each of them is worth: the course of the event,
// exp(-(t - t_0)^2 / 2 tau^2), divided by its sum. A feature's own frame is among them. In a cycle what reaches beyond an
// end goes on at the other one; each frame is worth what it is at the nearest of its times. Ascending.
inline std::vector<std::pair<std::size_t, double>> feature_presence(const Feature_point& f, std::size_t frames,
                                                                    double frame_duration, bool is_cyclic = false)
{
  const double reach = 2 * f.tau / frame_duration, middle = f.time / frame_duration, period = double(frames);
  std::vector<std::pair<std::size_t, double>> result;
  double sum = 0;
  for (std::size_t m = 0; m < frames; ++m) {
    double away = double(m) - middle;
    if (is_cyclic) away -= period * std::round(away / period);
    if (!(std::abs(away) <= reach)) continue;
    const double x = f.tau > 0 ? away * frame_duration / f.tau : 0;
    result.emplace_back(m, std::exp(-x * x / 2));
    sum += result.back().second;
  }
  if (result.empty()) return {{f.frame, 1.}};
  for (auto& m : result) m.second /= sum;
  return result;
}

} // namespace internal

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_FEATURE_PRESENCE_H
