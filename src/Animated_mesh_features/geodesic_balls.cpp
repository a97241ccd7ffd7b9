// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Animated_mesh_features/Geodesic_balls/Heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/instances.inl>

namespace CGAL {
namespace Animated_mesh_features {

CGAL_ANIMATED_MESH_FEATURES_BALLS_INSTANCE(Heat_method_geodesic_balls);

} // namespace Animated_mesh_features
} // namespace CGAL
