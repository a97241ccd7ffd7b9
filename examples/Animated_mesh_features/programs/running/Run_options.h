// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RUNNING_RUN_OPTIONS_H
#define PROGRAMS_RUNNING_RUN_OPTIONS_H

#include <cstddef>
#include <optional>
#include <string>

namespace Programs {

class Option_group;

// What a program may use, and how much it says.
struct Run_options
{
  std::size_t threads = 0;           // 0: all
  std::optional<std::size_t> memory; // bytes; none: what is available, and nothing on a disk
  std::string scratch_directory;     // empty: default_scratch_directory()

  bool quiet = false, verbose = false;
};

// --quiet and --verbose
void add_message_options(Option_group& group, Run_options& options);

// --threads, --memory and --scratch
void add_resource_options(Option_group& group, Run_options& options);

// To be called when all options are there.
// throws Option_error if options do not go together.
void check(const Run_options& options);

// On a disk, as far as can be told.
std::string default_scratch_directory();

} // namespace Programs

#endif // PROGRAMS_RUNNING_RUN_OPTIONS_H
