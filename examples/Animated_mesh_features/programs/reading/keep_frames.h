// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_READING_KEEP_FRAMES_H
#define PROGRAMS_READING_KEEP_FRAMES_H

#include "reading/Reading_options.h"
#include "reading/Values.h"

#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>

namespace Programs {

// Leaves out the frames that are not in the range, and tells it. From then on, frames and times count from the first that
// is left. In linear time, with one coordinate of all frames twice in memory for a moment.
// throws Option_error if there are no such frames.
void keep_frames(const Frame_range& range, CGAL::Animated_mesh_features::IO::Animation_file_data<FT>& data);

// Leaves out the last frame if it repeats the first, as of a clip that is made for a loop, and tells it. Likewise.
void leave_out_repeated_frame(CGAL::Animated_mesh_features::IO::Animation_file_data<FT>& data);

} // namespace Programs

#endif // PROGRAMS_READING_KEEP_FRAMES_H
