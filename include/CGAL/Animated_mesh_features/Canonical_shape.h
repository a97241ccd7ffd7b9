// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_CANONICAL_SHAPE_H
#define CGAL_ANIMATED_MESH_FEATURES_CANONICAL_SHAPE_H

#include <CGAL/Animated_mesh_features/Rest_shape.h>
#include <CGAL/Animated_mesh_features/internal/Flat_animation.h>

#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

template <class FT>
std::vector<Rest_shape::Point> canonical_shape(const internal::Flat_animation<FT>& animation);

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_CANONICAL_SHAPE_H
