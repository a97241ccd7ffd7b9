// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_OUTER_SIDES_H
#define PROGRAMS_RENDERING_OUTER_SIDES_H

#include "rendering/Surface.h"

#include <cstdint>
#include <vector>

namespace Programs::Rendering {

// For each triangle, which of its sides is outside, 1 for that from which its corners are counterclockwise, -1 for the other;
// 0 where there is no outside, since the part of the surface that it belongs to is open. A part is closed if its borders
// together are no longer than a tenth of its extent, as around eyes: hardly any light gets through. O(M log M) time for M
// triangles, which agree with their neighbours on which side is which.
std::vector<std::int8_t> outer_sides(const std::vector<Eigen::Vector3d>& points,
                                     const std::vector<Surface::Triangle>& triangles);

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_OUTER_SIDES_H
