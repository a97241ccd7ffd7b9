// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RUNNING_RUN_PROGRAM_H
#define PROGRAMS_RUNNING_RUN_PROGRAM_H

#include <functional>
#include <string>

namespace Programs {

enum Exit_code
{
  SUCCESS = 0,
  FAILURE = 1, // whatever the user cannot help: out of memory, for instance
  BAD_USAGE = 2,
  BAD_INPUT = 3,
  CANNOT_WRITE = 4,
  INTERRUPTED = 128 // plus the number of the signal, as shells have it
};

// Runs a program, tells on the standard error output what went wrong, and returns the exit code.
int run_program(const std::string& name, const std::function<void()>& run);

// Of the program and the libraries that it was built with: one line.
std::string version_line(const std::string& name);

} // namespace Programs

#endif // PROGRAMS_RUNNING_RUN_PROGRAM_H
