// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/write_png.h"

#include "drawing/Canvas.h"
#include "pictures/picture_of_scene.h"

#include <string>

namespace Programs {

void write_png(std::ostream& os, const Shown_scene& scene, const Picture_options& options)
{
  const std::string png = Canvas(picture_of_scene(scene, options)).file();
  os.write(png.data(), std::streamsize(png.size()));
}

} // namespace Programs
