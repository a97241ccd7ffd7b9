// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_INSTANCES_INL
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_INSTANCES_INL

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#include <CGAL/tags.h>

// Included by the header that defines what is declared here, and by `src/`; not on its own.
//
// What the compiled library has of this room: declared here, so that nobody else compiles it, defined in `src/`.
#define CGAL_ANIMATED_MESH_FEATURES_BALLS_INSTANCE(Balls)                                                           \
  template Compressed_rows Balls::operator()(const Rest_shape&, double,                                            \
                                             const Task_loop<CGAL::Parallel_if_available_tag, Any_visitor>&) const

namespace CGAL {
namespace Animated_mesh_features {

extern CGAL_ANIMATED_MESH_FEATURES_BALLS_INSTANCE(Heat_method_geodesic_balls);

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_INSTANCES_INL
