// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PICTURES_STRONGEST_FRAMES_H
#define PROGRAMS_PICTURES_STRONGEST_FRAMES_H

#include "scenes/Shown_scene.h"

#include <cstddef>
#include <vector>

namespace Programs {

// The frames that show most, at most so many: those of the strongest features, which come first, chosen apart in time, in
// their order. Features of different places come first: in a motion that repeats itself, the strongest of all are often
// one and the same, again and again. At least one frame: the middle one, if there are no features.
std::vector<std::size_t> strongest_frames(const std::vector<Shown_feature>& features, std::size_t number_of_frames,
                                          std::size_t most = 6);

} // namespace Programs

#endif // PROGRAMS_PICTURES_STRONGEST_FRAMES_H
