// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SIMPLIFY_ANIMATION_WANTED_LEVELS_H
#define SIMPLIFY_ANIMATION_WANTED_LEVELS_H

#include "simplify_animation/Command_line.h"
#include "simplify_animation/Measurement.h"

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Applications/Simplified_animation.h>

#include <cstddef>
#include <vector>

namespace Simplify_animation {

// The numbers of vertices that are asked for; for an error, those among which is chosen.
std::vector<std::size_t> wanted_levels(const Command_line& options,
                                       const CGAL::Animated_mesh_features::Rest_shape& rest);

// The coarsest level whose error (% of the diagonal) is small enough, by halving: errors grow as vertices become fewer.
void keep_coarsest_within(double error, double diagonal, const Measurement& measure,
                          CGAL::Animated_mesh_features::Simplified_animation& result);

} // namespace Simplify_animation

#endif // SIMPLIFY_ANIMATION_WANTED_LEVELS_H
