// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares animations of different meshes: which events they have in common, which time of one is which of the other,
// how unlike they are, and which of a collection is most alike.

#include "compare_animations/Command_line.h"
#include "running/run_program.h"

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc <= 1) {
    std::cerr << Compare_animations::overview();
    return Programs::BAD_USAGE;
  }
  return Programs::run_program("compare_animations", [&] { Compare_animations::run_command_line(argc, argv); });
}
