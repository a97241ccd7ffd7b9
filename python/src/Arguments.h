// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_MODULE_ARGUMENTS_H
#define PYTHON_MODULE_ARGUMENTS_H

#include "compare_animations/Settings.h"
#include "detect_features/Method_options.h"
#include "output/Output_options.h"
#include "reading/Reading_options.h"
#include "running/Run_options.h"
#include "simplify_animation/Command_line.h"

#include <string>
#include <vector>

namespace Python_module {

// Options as the command line has them, "--name=value": keywords of Python become such texts, so that they mean the same
// as there, have the same defaults, and are refused in the same words.
typedef std::vector<std::string> Arguments;

struct Options
{
  Programs::Reading_options reading;
  Detect_features::Method_options method;
  Programs::Output_options output;
  Compare_animations::Settings comparison;
  Simplify_animation::Command_line simplification;
  Programs::Run_options run;
};

// Which of them a function takes.
enum Taken
{
  READING = 1,
  METHOD = 2,
  OUTPUT = 4,
  COMPARISON = 8,
  SIMPLIFICATION = 16
};

// throws Option_error.
Options options_of(const Arguments& arguments, int taken);

// "--name=value" of all options there are, in the form of the help text.
std::string help_of(int taken);

} // namespace Python_module

#endif // PYTHON_MODULE_ARGUMENTS_H
