// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_COLOUR_SCALES_H
#define PROGRAMS_SCENES_COLOUR_SCALES_H

#include "scenes/Shown_scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace Programs {

// Where each feature's tau lies on the scale of colours: between the shortest and the longest one, by ratio, from 0 to 1.
std::vector<double> relative_taus(const std::vector<Shown_feature>& features);

// The colour of each feature, by that: red, green, blue, encoded as sRGB.
std::vector<std::array<std::uint8_t, 3>> duration_colours_of(const std::vector<Shown_feature>& features);

// The value that 99 % of a field do not exceed: the end of a scale of colours that a few spikes cannot stretch. 0 if the
// field is 0 nearly everywhere, or nowhere positive.
double top_of_scale(const Shown_values& field);

} // namespace Programs

#endif // PROGRAMS_SCENES_COLOUR_SCALES_H
