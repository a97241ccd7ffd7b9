// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Which time of one animation is which of another one that does the same, now slower and now faster, and how unlike
// they are. The field is one of your own here; of a deformation it is the same.

#include <CGAL/Animated_mesh_features/Applications/align_animations.h>
#include <CGAL/Animated_mesh_features/Applications/animation_activity.h>
#include <CGAL/Animated_mesh_features/Applications/animation_distance.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
typedef AMF::Spatio_temporal_field<double> Field;

// A wave that passes along a row of places, the later the further; `clock` tells what time it is in the motion.
template <class Clock>
AMF::Activity wave(std::size_t frames, double frame_duration, const Clock& clock)
{
  const std::size_t places = 10;
  Field field(places, frames);
  for (std::size_t v = 0; v < places; ++v)
    for (std::size_t f = 0; f < frames; ++f) {
      const double late = clock(double(f) * frame_duration) - 0.25 * double(v) - 0.4;
      field(v, f) = (1 + 0.1 * double(v)) * std::exp(-late * late / 0.08);
    }
  const std::vector<double> areas(places, 1);
  std::vector<double> eccentricities; // of a mesh, those of Surface_landmarks
  for (std::size_t v = 0; v < places; ++v) eccentricities.push_back(0.7 + 0.1 * double(v));
  return AMF::animation_activity(field, areas, eccentricities, frame_duration);
}

int main()
{
  const auto warped = [](double t) { return t + 0.12 * std::sin(2.1 * t); };
  const AMF::Activity a = wave(60, 1. / 20, warped);                     // at 20 frames a second
  const AMF::Activity b = wave(90, 1. / 30, [](double t) { return t; }); // at 30

  //! [align]
  const AMF::Time_alignment alignment = AMF::align_animations(a, b);
  for (double t = 0; t <= 3; t += 0.5)
    std::cout << t << " s is " << alignment.to_b(t) << " s (" << warped(t) << ")" << std::endl;
  std::cout << "confidence " << alignment.confidence << ", distance " << AMF::animation_distance(a, b) << std::endl;
  //! [align]
  return std::abs(alignment.to_b(1.5) - warped(1.5)) < 0.1 ? 0 : 1;
}
