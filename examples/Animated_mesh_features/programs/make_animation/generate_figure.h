// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAKE_ANIMATION_GENERATE_FIGURE_H
#define MAKE_ANIMATION_GENERATE_FIGURE_H

#include "make_animation/Generation_options.h"

#include "generators/Generated_animation.h"
#include "generators/figure_joints.h"

#include <vector>

namespace Make_animation {

// Compiled on its own: CGAL's remesher, of which the figure is made, takes a compiler twenty seconds.
// throws Option_error.
Animated_mesh_generators::Generated_animation generate_figure(const Generation_options& options);

// The joints of that figure, with their angles at these times (s).
std::vector<Animated_mesh_generators::Figure_joint>
joints_of_figure(const Animated_mesh_generators::Generated_animation& figure, const std::vector<double>& times);

} // namespace Make_animation

#endif // MAKE_ANIMATION_GENERATE_FIGURE_H
