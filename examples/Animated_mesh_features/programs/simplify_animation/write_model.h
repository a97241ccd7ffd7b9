// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SIMPLIFY_ANIMATION_WRITE_MODEL_H
#define SIMPLIFY_ANIMATION_WRITE_MODEL_H

#include "simplify_animation/Model_texture.h"

#include <CGAL/Animated_mesh_features/Applications/Simplified_animation.h>
#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>
#include <CGAL/Animated_mesh_features/IO/Vertex_origins.h>

#include <ostream>
#include <string>

namespace Simplify_animation {

// Writes a level of a model that was simplified as GLB: its nodes and all of its clips as they are, and one mesh, whose
// vertices are moved by the joints of those that they follow, by at most four. Materials and textures are left out.
// `origins`: which vertices of the model the vertices that were simplified are made of. `texture`: null, or where they
// are in it, which is written too. `name`: of the model, for messages. throws Input_error if the model has morph targets, more joints than glTF has numbers for, or a vertex
// follows others whose coordinates are not the same.
void write_model(std::ostream& os, const CGAL::Animated_mesh_features::IO::Keyframed_model& model,
                 const CGAL::Animated_mesh_features::IO::Vertex_origins& origins,
                 const CGAL::Animated_mesh_features::Animation_level& level, const Model_texture* texture,
                 const std::string& name);

} // namespace Simplify_animation

#endif // SIMPLIFY_ANIMATION_WRITE_MODEL_H
