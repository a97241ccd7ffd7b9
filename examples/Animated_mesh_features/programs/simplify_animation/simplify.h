// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SIMPLIFY_ANIMATION_SIMPLIFY_H
#define SIMPLIFY_ANIMATION_SIMPLIFY_H

#include "reading/Sequence.h"

#include <CGAL/Animated_mesh_features/Applications/Simplification_options.h>
#include <CGAL/Animated_mesh_features/Applications/Simplified_animation.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>

#include <functional>
#include <vector>

namespace Simplify_animation {

// simplify_animation() with guidance by features, or without any: compiled once.
CGAL::Animated_mesh_features::Simplified_animation
simplify(const Programs::Sequence& sequence, const CGAL::Animated_mesh_features::Simplification_options& options,
         const std::vector<CGAL::Animated_mesh_features::Feature_point>& features, double strength,
         const std::function<bool(double)>& watch);

} // namespace Simplify_animation

#endif // SIMPLIFY_ANIMATION_SIMPLIFY_H
