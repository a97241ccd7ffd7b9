// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EVALUATE_FEATURES_WRITE_REGION_MESH_H
#define EVALUATE_FEATURES_WRITE_REGION_MESH_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <ostream>
#include <vector>

namespace Evaluate_features {

// Writes the surface at rest as binary PLY, coloured by a value of each vertex, which is also the vertex property "quality";
// from the least colour at 0 to the greatest at the largest value.
void write_region_mesh(std::ostream& os, const CGAL::Animated_mesh_features::Rest_shape& shape,
                       const std::vector<float>& values);

} // namespace Evaluate_features

#endif // EVALUATE_FEATURES_WRITE_REGION_MESH_H
