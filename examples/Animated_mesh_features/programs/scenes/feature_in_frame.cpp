// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/feature_in_frame.h"

#include <cmath>

using CGAL::Animated_mesh_features::Feature_point;

namespace Programs {

bool lives_in_frame(const Feature_point& feature, std::size_t f, double frame_duration)
{
  return f == feature.frame || std::abs(double(f) * frame_duration - feature.time) <= feature_life * feature.tau;
}

double opacity_in_frame(const Feature_point& feature, std::size_t f, double frame_duration)
{
  if (!lives_in_frame(feature, f, frame_duration)) return 0;
  if (!(feature.tau > 0)) return 1; // then it lives in one frame only
  const double distance = (double(f) * frame_duration - feature.time) / feature.tau;
  return std::exp(-distance * distance / 2);
}

std::array<double, 3> position_in_frame(const Shown_sequence& sequence, const Feature_point& feature, std::size_t f)
{
  const auto& animation = sequence.trajectories();
  std::array<double, 3> position = {{0, 0, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t v = feature.triangle[i];
    const double b = feature.barycentric_coordinates[i];
    position[0] += b * animation.x(v, f);
    position[1] += b * animation.y(v, f);
    position[2] += b * animation.z(v, f);
  }
  return position;
}

} // namespace Programs
