// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_RUN_ALL_CLIPS_H
#define DETECT_FEATURES_RUN_ALL_CLIPS_H

#include "detect_features/Command_line.h"

namespace Detect_features {

// Runs the program on each clip of a model by itself, and ends with a table of all. What is wrong with a clip is told, and the
// others go on.
// throws Input_error at the end if there was such a clip, or Option_error if no clip goes with the options; at once, what run()
// throws if it is not the clip's fault: Output_error, Cancelled, bad_alloc.
void run_all_clips(const Command_line& command_line);

} // namespace Detect_features

#endif // DETECT_FEATURES_RUN_ALL_CLIPS_H
