// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Simplifies an animated mesh for all of its frames at once: meshes, their frames, and how far they are from the
// original.

#include "running/run_program.h"
#include "simplify_animation/Command_line.h"
#include "simplify_animation/run.h"

#include <iostream>

using namespace Simplify_animation;

int main(int argc, char* argv[])
{
  return Programs::run_program("simplify_animation", [&] {
    const Command_line options = parse_command_line(argc, argv);
    if (options.help)
      std::cout << usage() << std::flush;
    else if (options.version)
      std::cout << Programs::version_line("simplify_animation") << std::flush;
    else
      run(options);
  });
}
