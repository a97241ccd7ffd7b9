// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line program of the package: an animation in files goes in, a file of its spatio-temporal feature points
// comes out. Results go to files or to the standard output, messages to the standard error output.

#include "detect_features/Command_line.h"
#include "detect_features/run.h"
#include "detect_features/run_all_clips.h"
#include "detect_features/short_usage.h"
#include "running/run_program.h"

#include <iostream>

using namespace Detect_features;

int main(int argc, char* argv[])
{
  // The standard output is for results: a script that lost its arguments must not take this for one.
  if (argc <= 1) {
    std::cerr << short_usage();
    return Programs::BAD_USAGE;
  }
  return Programs::run_program("detect_features", [&] {
    const Command_line command_line = parse_command_line(argc, argv);
    if (command_line.help)
      std::cout << full_usage() << std::flush;
    else if (command_line.version)
      std::cout << Programs::version_line("detect_features") << std::flush;
    else if (command_line.manual_page)
      std::cout << manual_page() << std::flush;
    else if (command_line.completion)
      std::cout << completion(*command_line.completion) << std::flush;
    else if (command_line.has_all_clips())
      run_all_clips(command_line);
    else
      run(command_line);
  });
}
