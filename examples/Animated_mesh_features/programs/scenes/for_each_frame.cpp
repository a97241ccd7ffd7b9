// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/for_each_frame.h"

#include "running/Interruption.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace Programs {

namespace {

bool is_finite(const std::vector<float>& values)
{
  return std::all_of(values.begin(), values.end(), [](float x) { return std::isfinite(x); });
}

void check_frame(const Scene_frame& frame)
{
  if (!is_finite(frame.xyz) || !std::all_of(frame.fields.begin(), frame.fields.end(), is_finite))
    throw CGAL::Animated_mesh_features::Output_error("frame " + std::to_string(frame.index) +
                                                     " has numbers too large for single precision");
}

} // namespace

// In memory the frames of a vertex are neighbours: several are read at a time, so that each cache line is fetched once.
void for_each_frame(const Shown_scene& scene, const std::function<void(const Scene_frame&)>& use)
{
  constexpr std::size_t frames_at_once = 64 / sizeof(double); // a cache line
  const auto& animation = scene.sequence.trajectories();
  const std::size_t n = animation.number_of_vertices(), frames = animation.number_of_frames();
  std::vector<Scene_frame> batch(frames_at_once);
  for (Scene_frame& frame : batch) {
    frame.xyz.resize(3 * n);
    frame.fields.assign(scene.fields.size(), std::vector<float>(n));
  }
  for (std::size_t begin = 0; begin < frames; begin += frames_at_once) {
    const std::size_t size = (std::min)(frames_at_once, frames - begin);
    const Shown_values* const coordinates[] = {&animation.x, &animation.y, &animation.z};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t v = 0; v < n; ++v)
        for (std::size_t f = 0; f < size; ++f)
          batch[f].xyz[3 * v + c] = static_cast<float>((*coordinates[c])(v, begin + f));
    for (std::size_t i = 0; i < scene.fields.size(); ++i)
      for (std::size_t v = 0; v < n; ++v)
        for (std::size_t f = 0; f < size; ++f)
          batch[f].fields[i][v] = static_cast<float>((*scene.fields[i].values)(v, begin + f));
    for (std::size_t f = 0; f < size; ++f) {
      batch[f].index = begin + f;
      Interruption::check();
      check_frame(batch[f]);
      use(batch[f]);
    }
  }
}

} // namespace Programs
