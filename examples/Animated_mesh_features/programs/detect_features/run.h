// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_RUN_H
#define DETECT_FEATURES_RUN_H

#include "detect_features/Command_line.h"
#include "detect_features/clip_table.h"

#include <string>

namespace Detect_features {

// Reads the animation, finds its features and writes all files. Messages go to the standard error output.
// throws Error.
void run(const Command_line& command_line);

// The same with `name` before each line that is told, and `progress` before the progress; with a name, there is no summary.
Outcome run(const Command_line& command_line, const std::string& name, const std::string& progress);

} // namespace Detect_features

#endif // DETECT_FEATURES_RUN_H
