// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAKE_ANIMATION_GENERATION_OPTIONS_H
#define MAKE_ANIMATION_GENERATION_OPTIONS_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace Make_animation {

enum class Body
{
  FIGURE,
  CYLINDER
};

// What is generated, and how finely.
struct Generation_options
{
  bool help = false; // nothing else counts then

  Body body = Body::FIGURE;
  std::optional<std::size_t> vertices; // roughly
  std::optional<std::size_t> frames;   // none: as many as show the whole motion
  double frames_per_second = 30;
  std::string base;   // of the names of the files
  std::string events; // the file of the figure's joints; empty: none

  // Typing errors beyond these would fill the memory before they fail.
  static constexpr std::size_t most_vertices = 10000000;
  static constexpr std::size_t most_frames = 1000000;
};

// throws Option_error, with a message for the user.
Generation_options parse_command_line(int argc, const char* const* argv);

std::string usage();

} // namespace Make_animation

#endif // MAKE_ANIMATION_GENERATION_OPTIONS_H
