// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_METHOD_VALUES_H
#define DETECT_FEATURES_METHOD_VALUES_H

#include <CGAL/Animated_mesh_features/Deformation/Triangle_weights.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_selection.h>

#include <cstddef>

namespace Detect_features {

// What the presets differ in besides what is chosen by name, where the options leave the choice.
struct Method_values
{
  double alpha;
  CGAL::Animated_mesh_features::Triangle_weights triangle_weights;
  CGAL::Animated_mesh_features::Feature_selection selection;
  std::size_t box_width; // frames; 0: the box follows the scales, or there is none
};

} // namespace Detect_features

#endif // DETECT_FEATURES_METHOD_VALUES_H
