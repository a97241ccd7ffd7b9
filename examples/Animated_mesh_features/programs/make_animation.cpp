// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes a generated animation: the rest shape as OBJ, the frames as PC2 point cache.

#include "make_animation/Generation_options.h"
#include "make_animation/run.h"
#include "running/run_program.h"

#include <iostream>

using namespace Make_animation;

int main(int argc, char* argv[])
{
  return Programs::run_program("make_animation", [&] {
    const Generation_options options = parse_command_line(argc, argv);
    if (options.help)
      std::cout << usage() << std::flush;
    else
      run(options);
  });
}
