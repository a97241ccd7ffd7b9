// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SIMPLIFY_ANIMATION_RUN_H
#define SIMPLIFY_ANIMATION_RUN_H

#include "simplify_animation/Command_line.h"

namespace Simplify_animation {

// Reads, simplifies, measures, writes.
// throws Error.
void run(const Command_line& options);

} // namespace Simplify_animation

#endif // SIMPLIFY_ANIMATION_RUN_H
