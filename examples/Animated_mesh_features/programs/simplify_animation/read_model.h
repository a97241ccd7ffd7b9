// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SIMPLIFY_ANIMATION_READ_MODEL_H
#define SIMPLIFY_ANIMATION_READ_MODEL_H

#include "reading/Reading_options.h"

#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>

#include <string>

namespace Simplify_animation {

// throws Option_error if the input is no animated model in glTF.
// throws Option_error, which says that `option` needs one.
void check_is_model(const Programs::Reading_options& options, const std::string& option);

// The model of which the animation was made.
// throws Option_error if it is none in glTF, or the program was built without what reads it; Input_error.
CGAL::Animated_mesh_features::IO::Keyframed_model read_model(const Programs::Reading_options& options);

} // namespace Simplify_animation

#endif // SIMPLIFY_ANIMATION_READ_MODEL_H
