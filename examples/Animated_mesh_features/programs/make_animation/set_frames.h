// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAKE_ANIMATION_SET_FRAMES_H
#define MAKE_ANIMATION_SET_FRAMES_H

#include "make_animation/Generation_options.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace Make_animation {

// Gives a generator's options the frames that were asked for, or as many as the generator's own number lasts.
// throws Option_error.
template <class Options>
void set_frames(const Generation_options& asked, Options& options)
{
  const double frames =
      asked.frames ? double(*asked.frames)
                   : std::round(double(options.number_of_frames) / options.frame_rate * asked.frames_per_second);
  if (frames > double(Generation_options::most_frames))
    throw CGAL::Animated_mesh_features::Option_error("--fps makes more than a million frames");
  options.number_of_frames = std::size_t((std::max)(1., frames));
  options.frame_rate = asked.frames_per_second;
}

} // namespace Make_animation

#endif // MAKE_ANIMATION_SET_FRAMES_H
