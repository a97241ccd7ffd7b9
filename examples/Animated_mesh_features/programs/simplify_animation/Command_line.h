// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SIMPLIFY_ANIMATION_COMMAND_LINE_H
#define SIMPLIFY_ANIMATION_COMMAND_LINE_H

#include "options/Names.h"
#include "options/Option_groups.h"
#include "reading/Reading_options.h"
#include "running/Run_options.h"

#include <CGAL/Animated_mesh_features/Applications/Simplification_options.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace Simplify_animation {

// How levels are written.
enum class Form
{
  OBJ, // a mesh and a point cache
  PLY, // a folder with a mesh for each frame
  GLB  // of an animated model: the model, with its skeleton and all clips
};

Programs::Names<Form> names(Form);

struct Command_line
{
  bool help = false, version = false;

  Programs::Reading_options reading;
  Programs::Run_options running;

  // how much is to be left: one of them
  std::vector<std::size_t> vertices;
  std::vector<double> ratios;
  std::optional<double> error; // % of the diagonal

  CGAL::Animated_mesh_features::Simplification_options method;
  std::optional<std::size_t> refinements; // none: as suits the target
  std::string features;                   // file; empty: none
  std::optional<double> strength;
  std::vector<std::string> further; // point caches of other animations of the mesh

  std::string base; // of the files that are written; empty: none
  Form form = Form::OBJ;
  bool keep_seams = false;
  std::string json, plot, binding; // files; empty: none

  bool measures() const { return !json.empty() || !plot.empty() || error || !running.quiet; }
};

// How much is left.
void add_target_options(Programs::Option_group& group, Command_line& options);

// throws Option_error unless that is told in one way.
void check_target(const Command_line& options);

// How it is chosen what is left.
void add_simplification_options(Programs::Option_group& group, Command_line& options);

// All of that but the numbers of vertices.
CGAL::Animated_mesh_features::Simplification_options simplification_options(const Command_line& options);

// throws Option_error.
Command_line parse_command_line(int argc, const char* const* argv);

std::string usage();

} // namespace Simplify_animation

#endif // SIMPLIFY_ANIMATION_COMMAND_LINE_H
