// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_HTML_FILE_H
#define DETECT_FEATURES_HTML_FILE_H

#include "detect_features/Command_line.h"
#include "output/Scene_files.h"

#include <cstddef>
#include <memory>
#include <string>

namespace Detect_features {

// Why this program cannot write pages; empty if it can.
std::string missing_viewer();

// If a page is asked for: whether this program has the viewer, and the page has room for an animation of that size. Unless
// the command line says --quiet, tells if there is room for a part of the frames only.
// throws Option_error.
void check_html(const Command_line& command_line, std::size_t number_of_vertices, std::size_t number_of_frames);

// throws Option_error, Output_error.
std::unique_ptr<Scene_file> open_html_file(const std::string& path, std::size_t frame_step);

} // namespace Detect_features

#endif // DETECT_FEATURES_HTML_FILE_H
