// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_ANIMATIONS_COMMAND_LINE_H
#define COMPARE_ANIMATIONS_COMMAND_LINE_H

#include "compare_animations/Settings.h"
#include "options/Option_groups.h"

#include <string>

namespace Compare_animations {

// How animations are compared.
void add_comparison_options(Programs::Option_group& group, Settings& settings);

// throws Option_error if an option of these is out of its range.
void check_comparison(const Settings& settings);

// Understands the command line, compares what it asks for, prints a table and writes the files.
// throws Error; std::runtime_error if a check finds a difference.
void run_command_line(int argc, const char* const* argv);

// What there is to do, in a few lines.
std::string overview();

} // namespace Compare_animations

#endif // COMPARE_ANIMATIONS_COMMAND_LINE_H
