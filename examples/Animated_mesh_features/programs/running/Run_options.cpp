// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "running/Run_options.h"

#include "options/Option_groups.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstdlib>
#include <filesystem>

using CGAL::Animated_mesh_features::Option_error;

namespace Programs {

void add_message_options(Option_group& group, Run_options& o)
{
  group.add_switch("quiet,q", o.quiet, "say nothing but errors");
  group.add_switch("verbose,v", o.verbose, "tell about the data, and the time and memory of each stage");
}

void add_resource_options(Option_group& group, Run_options& o)
{
  group.add("threads", "N", "how many threads to use at most; the result is the same (default: all)",
            [&](const Argument& a) { o.threads = a.count(); });
  group.add(
      "memory", "SIZE",
      "how much memory to use at most, such as 4G or 800M; what does not fit goes to files on the scratch directory, "
      "with the same result (default: what is available, and nothing on a disk)",
      [&](const Argument& a) { o.memory = a.bytes(); });
  group.add("scratch", "DIR",
            "the scratch directory, on a disk (default: that of the environment variable TMPDIR, or /var/tmp)",
            [&](const Argument& a) { o.scratch_directory = a.text(); });
}

void check(const Run_options& o)
{
  if (o.quiet && o.verbose) throw Option_error("--quiet and --verbose exclude each other");
  if (!o.scratch_directory.empty() && !o.memory)
    throw Option_error("--scratch goes with --memory, which says when to use it");
}

std::string default_scratch_directory()
{
  const char* const directory = std::getenv("TMPDIR");
  if (directory != nullptr && *directory != '\0') return directory;
  return std::filesystem::is_directory("/var/tmp") ? "/var/tmp" : std::filesystem::temp_directory_path().string();
}

} // namespace Programs
