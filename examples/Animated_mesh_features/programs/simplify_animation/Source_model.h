// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SIMPLIFY_ANIMATION_SOURCE_MODEL_H
#define SIMPLIFY_ANIMATION_SOURCE_MODEL_H

#include "simplify_animation/Model_texture.h"

#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>

#include <optional>

namespace Simplify_animation {

// What of the model that the animation is read from is needed besides.
struct Source_model
{
  std::optional<CGAL::Animated_mesh_features::IO::Keyframed_model> model; // of --format glb
  std::optional<Model_texture> texture;                                   // of --keep-seams
};

} // namespace Simplify_animation

#endif // SIMPLIFY_ANIMATION_SOURCE_MODEL_H
