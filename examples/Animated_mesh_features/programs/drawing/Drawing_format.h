// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_DRAWING_DRAWING_FORMAT_H
#define PROGRAMS_DRAWING_DRAWING_FORMAT_H

namespace Programs {

enum class Drawing_format
{
  SVG,
  PDF,
  PNG
};

} // namespace Programs

#endif // PROGRAMS_DRAWING_DRAWING_FORMAT_H
