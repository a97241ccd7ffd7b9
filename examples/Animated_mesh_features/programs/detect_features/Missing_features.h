// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_MISSING_FEATURES_H
#define DETECT_FEATURES_MISSING_FEATURES_H

#include <cstddef>

namespace Detect_features {

// What tells why there are no features.
struct Missing_features
{
  double deformation = 0;            // the largest one, of any vertex in any frame
  std::size_t vertex = 0, frame = 0; // where it is
  double noise = 0;                  // up to which it is rounding
  double strength = 0, fit = 0;      // of the strongest minimum; 0 if there is none
};

} // namespace Detect_features

#endif // DETECT_FEATURES_MISSING_FEATURES_H
