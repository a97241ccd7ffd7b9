// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OUTPUT_ADD_PICTURE_OPTIONS_H
#define PROGRAMS_OUTPUT_ADD_PICTURE_OPTIONS_H

#include "output/Output_options.h"

namespace Programs {

class Option_group;

// What the picture shows, and from where; to be added after --png.
void add_picture_options(Option_group& group, Output_options& options);

} // namespace Programs

#endif // PROGRAMS_OUTPUT_ADD_PICTURE_OPTIONS_H
