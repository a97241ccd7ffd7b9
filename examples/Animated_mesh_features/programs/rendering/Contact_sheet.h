// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_CONTACT_SHEET_H
#define PROGRAMS_RENDERING_CONTACT_SHEET_H

#include <cstddef>
#include <vector>

namespace Programs::Rendering {

// A rectangle of an image, pixels.
struct Panel
{
  std::size_t left = 0, top = 0;
  std::size_t width = 0, height = 0;
};

// Divides a rectangle into equal panels, row by row, so that pictures of a given shape, `aspect`: width by height, are
// as large as possible in them.
std::vector<Panel> panels(std::size_t number, std::size_t width, std::size_t height, double aspect);

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_CONTACT_SHEET_H
