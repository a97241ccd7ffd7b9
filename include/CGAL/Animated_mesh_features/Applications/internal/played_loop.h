// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_PLAYED_LOOP_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_PLAYED_LOOP_H

#include <CGAL/Animated_mesh_features/Applications/Activity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A loop as it is played from its sample `first` on, for as many samples as are wanted: an activity that ends.
inline Activity played_loop(const Activity& loop, std::size_t first, std::size_t samples)
{
  Activity result = loop;
  result.samples = samples;
  result.is_cyclic = false;
  const auto play = [&](const std::vector<float>& from, std::vector<float>& to) {
    const std::size_t width = from.size() / loop.samples;
    to.resize(samples * width);
    for (std::size_t t = 0; t < samples; ++t)
      std::copy_n(from.begin() + std::ptrdiff_t((first + t) % loop.samples * width), width,
                  to.begin() + std::ptrdiff_t(t * width));
  };
  play(loop.mean, result.mean);
  play(loop.recurrence, result.recurrence);
  play(loop.places, result.places);
  return result;
}

// How often a loop is played beside another animation: as often as makes the durations most alike, at least once.
inline std::size_t number_of_plays(const Activity& loop, const Activity& other)
{
  if (!loop.is_cyclic) return 1;
  return std::size_t((std::max)(std::round(other.duration() / loop.duration()), 1.));
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_PLAYED_LOOP_H
