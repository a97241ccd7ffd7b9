// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_NUMBER_OF_PASSES_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_NUMBER_OF_PASSES_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cmath>
#include <cstddef>
#include <sstream>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// How many passes, each of which adds `unit`, come nearest to a variance.
// throws Option_error if that is no number, or one that nobody can wait for.
inline std::size_t number_of_passes(double variance, double unit)
{
  const double most = 1e9, passes = variance / unit;
  if (!(passes >= 0 && passes <= most)) {
    std::ostringstream message;
    message << "a filter would take " << passes << " passes for the variance " << variance << "; at most " << most
            << " are made";
    throw Option_error(message.str());
  }
  return std::size_t(std::llround(passes));
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_NUMBER_OF_PASSES_H
