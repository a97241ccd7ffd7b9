// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_BALL_REACH_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_BALL_REACH_H

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The reach of the search along edges, as a multiple of the radius. A path along edges is longer than the geodesic by
// at most 2 / sqrt(3) on equilateral triangles and by less than 2 on any triangulation without obtuse slivers; what
// lies beyond is either outside of the ball or on another sheet or component, to which the heat method leaks.
constexpr double ball_reach = 2;

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_BALL_REACH_H
