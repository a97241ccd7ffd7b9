// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAKE_ANIMATION_RUN_H
#define MAKE_ANIMATION_RUN_H

#include "make_animation/Generation_options.h"

namespace Make_animation {

// Generates the animation, writes both files, and tells about them on the standard output.
// throws Option_error, Output_error.
void run(const Generation_options& options);

} // namespace Make_animation

#endif // MAKE_ANIMATION_RUN_H
