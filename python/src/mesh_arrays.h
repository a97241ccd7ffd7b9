// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_MODULE_MESH_ARRAYS_H
#define PYTHON_MODULE_MESH_ARRAYS_H

#include "Shape_data.h"

#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace Python_module {

// Points of an N x 3 array; `what` names it in messages.
// throws Input_error if it has another shape or a coordinate is not finite.
template <class Point>
std::vector<Point> points_of(const Points_array& array, const std::string& what);

// Triangles of a T x 3 array, or of one with more corners, which are cut as a fan if that is wanted.
// throws Input_error if it has another shape, or a corner is none of the vertices.
std::vector<std::array<std::size_t, 3>> triangles_of(const Faces_array& array, std::size_t vertices, bool triangulate);

// T x 3
pybind11::array array_of(const std::vector<AMF::Rest_shape::Triangle>& triangles);

// N x 3
pybind11::array array_of(const std::vector<AMF::Rest_shape::Point>& points);

// The same memory, N x F, read-only if it is somebody else's, too; `owner` keeps it alive.
pybind11::array view_of(const Programs::Values& field, const pybind11::object& owner, bool is_shared = true);

} // namespace Python_module

#endif // PYTHON_MODULE_MESH_ARRAYS_H
