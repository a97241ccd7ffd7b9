// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_COMMAND_LINE_H
#define DETECT_FEATURES_COMMAND_LINE_H

#include "detect_features/Method_options.h"
#include "options/write_completion.h"
#include "output/Output_options.h"
#include "reading/Reading_options.h"
#include "running/Run_options.h"

#include <optional>
#include <string>

namespace Detect_features {

// What was asked for, complete and consistent as far as can be told without the data.
struct Command_line
{
  // nothing else counts if one of these is there
  bool help = false, version = false, manual_page = false;
  std::optional<Programs::Shell> completion;

  Programs::Reading_options reading;
  Method_options method;
  Programs::Output_options output;
  Programs::Run_options run;

  // --clip all
  bool has_all_clips() const { return reading.clip == "all"; }
};

// throws Option_error, with a message for the user.
Command_line parse_command_line(int argc, const char* const* argv);

std::string full_usage();

// a page for man(1), and what a shell completes the options by
std::string manual_page();
std::string completion(Programs::Shell shell);

} // namespace Detect_features

#endif // DETECT_FEATURES_COMMAND_LINE_H
