// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OUTPUT_HTML_FILE_H
#define PROGRAMS_OUTPUT_HTML_FILE_H

#include "output/Output_options.h"
#include "output/Scene_files.h"

#include <cstddef>
#include <memory>
#include <string>

namespace Programs {

// If a page is asked for, checks that this program has the viewer, and the page has room for an animation of that size.
// returns one line, or nothing: there is room for a part of the frames only.
// throws Option_error.
std::string html_notice(const Output_options& options, std::size_t number_of_vertices, std::size_t number_of_frames);

// throws Option_error, Output_error.
std::unique_ptr<Scene_file> open_html_file(const std::string& path, const Output_options& options);

} // namespace Programs

#endif // PROGRAMS_OUTPUT_HTML_FILE_H
