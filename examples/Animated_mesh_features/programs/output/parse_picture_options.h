// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OUTPUT_PARSE_PICTURE_OPTIONS_H
#define PROGRAMS_OUTPUT_PARSE_PICTURE_OPTIONS_H

#include "options/Argument.h"
#include "pictures/Picture_options.h"

// What the user types for a picture. All throw Option_error.

namespace Programs {

void parse_picture_frame(const Argument& argument, Picture_options& options);      // N
void parse_picture_size(const Argument& argument, Picture_options& options);       // WxH
void parse_picture_background(const Argument& argument, Picture_options& options); // RRGGBB
void parse_picture_view(const Argument& argument, Picture_options& options);       // AZIMUTH,ELEVATION
void parse_picture_up_axis(const Argument& argument, Picture_options& options);    // x, y or z

} // namespace Programs

#endif // PROGRAMS_OUTPUT_PARSE_PICTURE_OPTIONS_H
