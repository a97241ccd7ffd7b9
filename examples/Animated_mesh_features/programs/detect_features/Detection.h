// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_DETECTION_H
#define DETECT_FEATURES_DETECTION_H

#include "detect_features/Method_values.h"
#include "detect_features/Missing_features.h"
#include "detect_features/Searched_scales.h"
#include "reading/Sequence.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace Detect_features {

// The features, and the values that were used where the options left the choice.
struct Detection
{
  std::vector<Programs::Feature> features; // strongest first
  std::size_t number_of_minima = 0;
  Searched_scales scales;
  Method_values values;
  double ball_radius = 0;                  // length; 0 if no balls were needed
  bool bounds_ball_radius = false;         // the default is smaller, as balls would have too many vertices
  double closing_step = 0;                 // of a cyclic animation, see closing_step()
  std::optional<Missing_features> missing; // if there are no features
};

} // namespace Detect_features

#endif // DETECT_FEATURES_DETECTION_H
