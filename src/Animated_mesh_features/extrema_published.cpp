// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Animated_mesh_features/Extrema/find_response_extrema.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/instances.inl>

namespace CGAL {
namespace Animated_mesh_features {

CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INSTANCE(double, internal::Published_search);
CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INSTANCE(float, internal::Published_search);

} // namespace Animated_mesh_features
} // namespace CGAL
