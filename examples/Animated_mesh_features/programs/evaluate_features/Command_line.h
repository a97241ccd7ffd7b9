// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EVALUATE_FEATURES_COMMAND_LINE_H
#define EVALUATE_FEATURES_COMMAND_LINE_H

#include <string>

namespace Evaluate_features {

// Understands the command line, measures what it asks for, prints a table and writes the files.
// throws Error.
void run_command_line(int argc, const char* const* argv);

// What there is to measure, in a few lines.
std::string overview();

} // namespace Evaluate_features

#endif // EVALUATE_FEATURES_COMMAND_LINE_H
