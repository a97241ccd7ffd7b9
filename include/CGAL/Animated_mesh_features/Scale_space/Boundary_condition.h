// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_BOUNDARY_CONDITION_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_BOUNDARY_CONDITION_H

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesFilters

What smoothing in time takes for the frames before the first and after the last one. (Never zero: the field is not zero
there, and the false step at the ends makes several times as many spurious extrema as there are true ones.)

Of a cyclic animation, such as one step of a gait, the last frame is followed by the first: its period is F frames. Where the
last frame repeats the first, leave it out (see `last_frame_repeats_first()`).
*/
enum class Boundary_condition
{
  REFLECT,   ///< the mirror image of the row: ... 1 0 | 0 1 2 ...; keeps the mean. The default.
  REPLICATE, ///< the first and the last value
  TRUNCATE,  ///< nothing: the mean of the frames that exist
  PERIODIC   ///< the row again and again: ... F-2 F-1 | 0 1 2 ...; keeps the mean. For cyclic animations.
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_BOUNDARY_CONDITION_H
