// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAKE_ANIMATION_GENERATE_FIGURE_H
#define MAKE_ANIMATION_GENERATE_FIGURE_H

#include "make_animation/Generation_options.h"

#include "generators/Generated_animation.h"

namespace Make_animation {

// Compiled on its own: CGAL's remesher, of which the figure is made, takes a compiler twenty seconds.
// throws Option_error.
Animated_mesh_generators::Generated_animation generate_figure(const Generation_options& options);

} // namespace Make_animation

#endif // MAKE_ANIMATION_GENERATE_FIGURE_H
