// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures features that detect_features has found: a table on the standard output, figures as JSON, curves.

#include "evaluate_features/Command_line.h"
#include "running/run_program.h"

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc <= 1) {
    std::cerr << Evaluate_features::overview();
    return Programs::BAD_USAGE;
  }
  return Programs::run_program("evaluate_features", [&] { Evaluate_features::run_command_line(argc, argv); });
}
