// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_COLOUR_MAP_H
#define PROGRAMS_RENDERING_COLOUR_MAP_H

#include "rendering/Colour.h"

#include <cstddef>
#include <vector>

namespace Programs::Rendering {

// Numbers from 0 to 1 to colours, in perceptually uniform steps: a smooth curve through a few colours in CIELAB, travelled
// at constant speed, so that equal differences of the number are equal differences to the eye.
class Colour_map
{
public:
  // Fits the curve through colours in CIELAB (D65), at least two, and divides it into equal steps.
  explicit Colour_map(const std::vector<Eigen::Array3d>& corners);

  // numbers outside of [0, 1] get the colours of its ends
  Colour operator()(double t) const;

private:
  static constexpr std::size_t size = 256;

  std::vector<Colour> m_colours;
};

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_COLOUR_MAP_H
