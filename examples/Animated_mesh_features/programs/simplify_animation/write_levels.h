// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SIMPLIFY_ANIMATION_WRITE_LEVELS_H
#define SIMPLIFY_ANIMATION_WRITE_LEVELS_H

#include "reading/Sequence.h"
#include "simplify_animation/Command_line.h"
#include "simplify_animation/Source_model.h"

#include <CGAL/Animated_mesh_features/Applications/Simplified_animation.h>
#include <CGAL/Animated_mesh_features/IO/Vertex_origins.h>

#include <string>
#include <vector>

namespace Simplify_animation {

// the base of each level's files
std::vector<std::string> level_bases(const Command_line& options, std::size_t levels);

// all files that write_levels() writes
std::vector<std::string> level_files(const Command_line& options, std::size_t levels);

// Writes all levels: complete, down to the last byte, before one file takes its place.
// throws Output_error, and Input_error if a further animation is not of the mesh, or a model cannot be written.
void write_levels(const Command_line& options, const Programs::Sequence& sequence,
                  const CGAL::Animated_mesh_features::IO::Vertex_origins& origins, const Source_model& source,
                  const CGAL::Animated_mesh_features::Simplified_animation& result);

// which vertices each vertex follows
std::string binding_text(const CGAL::Animated_mesh_features::Simplified_animation& result);

} // namespace Simplify_animation

#endif // SIMPLIFY_ANIMATION_WRITE_LEVELS_H
