// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/feature_in_frame.h"

#include <algorithm>
#include <cmath>

using CGAL::Animated_mesh_features::Feature_point;

namespace Programs {

namespace {

// From a feature's time to a frame; in a cyclic animation the shorter way round.
double time_to_frame(const Feature_point& feature, std::size_t f, double frame_duration, double period)
{
  const double distance = std::abs(double(f) * frame_duration - feature.time);
  return period > 0 ? (std::min)(distance, period - distance) : distance;
}

} // namespace

double period(const Shown_scene& scene)
{
  return scene.is_cyclic ? double(scene.sequence.number_of_frames()) * scene.sequence.frame_duration() : 0;
}

bool lives_in_frame(const Feature_point& feature, std::size_t f, double frame_duration, double period)
{
  return f == feature.frame || time_to_frame(feature, f, frame_duration, period) <= feature_life * feature.tau;
}

double opacity_in_frame(const Feature_point& feature, std::size_t f, double frame_duration, double period)
{
  if (!lives_in_frame(feature, f, frame_duration, period)) return 0;
  if (!(feature.tau > 0)) return 1; // then it lives in one frame only
  const double distance = time_to_frame(feature, f, frame_duration, period) / feature.tau;
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
