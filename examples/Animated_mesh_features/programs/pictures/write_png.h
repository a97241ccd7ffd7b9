// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PICTURES_WRITE_PNG_H
#define PROGRAMS_PICTURES_WRITE_PNG_H

#include "pictures/Picture_options.h"
#include "scenes/Shown_scene.h"

#include <ostream>

namespace Programs {

// Writes a picture of a scene, see `picture_of_scene()` also for what is thrown, as PNG: 8 bits a channel, to be taken as
// sRGB, as everything does that is told nothing else. The stream is a binary one; errors are left in its state,
// `Output_file` reports them.
void write_png(std::ostream& os, const Shown_scene& scene, const Picture_options& options = Picture_options());

} // namespace Programs

#endif // PROGRAMS_PICTURES_WRITE_PNG_H
