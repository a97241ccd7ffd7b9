// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_COMMAND_LINE_H
#define DETECT_FEATURES_COMMAND_LINE_H

#include "detect_features/Method_options.h"
#include "output/Output_options.h"
#include "reading/Reading_options.h"
#include "running/Run_options.h"

#include <string>

namespace Detect_features {

// What was asked for, complete and consistent as far as can be told without the data.
struct Command_line
{
  bool help = false, version = false; // nothing else counts then

  Programs::Reading_options reading;
  Method_options method;
  Programs::Output_options output;
  Programs::Run_options run;
};

// throws Option_error, with a message for the user.
Command_line parse_command_line(int argc, const char* const* argv);

std::string full_usage();

} // namespace Detect_features

#endif // DETECT_FEATURES_COMMAND_LINE_H
