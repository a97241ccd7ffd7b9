// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_CHECK_TIMING_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_CHECK_TIMING_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// Throws unless there are frames enough, a positive time apart.
inline void check_timing(std::size_t number_of_frames, double frame_duration)
{
  // a feature has a frame before and a frame after it
  if (number_of_frames < 3)
    throw Input_error("there are " + std::to_string(number_of_frames) +
                      " frame(s); at least 3 are needed, since a feature has a frame before and one after it");
  if (!(frame_duration > 0) || !std::isfinite(frame_duration))
    throw Input_error("the time between frames is " + std::to_string(frame_duration) + " s; it must be positive");
}

} // namespace internal

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_CHECK_TIMING_H
