// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Palette.h"

namespace Programs::Rendering {

const Colour_map& field_colours()
{
  static const Colour_map map({{94, 0, 10}, {78, -16, 9}, {62, -29, 0}, {46, -24, -13}, {30, -10, -20}});
  return map;
}

const Colour_map& duration_colours()
{
  static const Colour_map map({{57, 65, 45}, {54, 65, 2}, {49, 52, -38}, {42, 34, -76}});
  return map;
}

} // namespace Programs::Rendering
