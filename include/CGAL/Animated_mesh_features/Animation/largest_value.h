// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_LARGEST_VALUE_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_LARGEST_VALUE_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

the largest absolute value of a field; 0 for an empty one. `O(N F)`.
*/
template <class FT>
double largest_value(const Spatio_temporal_field<FT>& field)
{
  FT largest = 0;
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f) largest = (std::max)(largest, std::abs(field(v, f)));
  return double(largest);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_LARGEST_VALUE_H
