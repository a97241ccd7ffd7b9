// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_THINNED_TRIANGLES_H
#define PROGRAMS_PAGE_THINNED_TRIANGLES_H

#include "scenes/surface_shapes.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace Programs {

// The triangles of a moving surface with fewer vertices, for pages that would be too large with all of them: vertices are
// taken away where the surface is flat in all of the `shapes`, the first of which is the rest shape, by collapsing an edge
// onto one of its ends. So what is left are vertices of the surface, and its motion is exact there. Borders stay.
//
// Going on until `most_vertices` are left that belong to a triangle, or until nothing can be taken away without turning a
// triangle over or changing the topology. In rounds of collapses that do not meet, those of least cost first: the distance
// of the collapsed vertex' new place from the planes of the triangles around it, at most in all shapes, plus a little of the
// edge's length.
//
// Deterministic. Time: about a dozen rounds to take away three quarters, each linear in the triangles and the shapes.
Triangles thinned_triangles(Triangles triangles, const std::vector<std::vector<Eigen::Vector3f>>& shapes,
                            std::size_t most_vertices);

} // namespace Programs

#endif // PROGRAMS_PAGE_THINNED_TRIANGLES_H
