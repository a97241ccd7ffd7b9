// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OUTPUT_CLIP_OUTPUTS_H
#define PROGRAMS_OUTPUT_CLIP_OUTPUTS_H

#include "output/Output_options.h"

#include <string>
#include <vector>

namespace Programs {

// Outputs of several clips, of which each has files of its own: a path of an output is a folder, in which files are called
// as clips, or has {clip} where the name of a clip is to be.

// A name for the files of each clip: what no file system takes, or a terminal would obey, becomes an underscore. All are
// different, whatever a file system makes of large letters.
std::vector<std::string> clip_file_names(const std::vector<std::string>& clips);

// throws Option_error if a path is neither a folder nor has {clip}, or it is the standard output.
void check_clip_outputs(const Output_options& options);

// The outputs of the clip whose files are called so.
Output_options outputs_of_clip(const Output_options& options, const std::string& file_name);

// Makes the folders of the outputs that are not there.
// throws Output_error if that cannot be done.
void make_folders(const std::vector<std::string>& paths);

} // namespace Programs

#endif // PROGRAMS_OUTPUT_CLIP_OUTPUTS_H
