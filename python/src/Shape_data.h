// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_MODULE_SHAPE_DATA_H
#define PYTHON_MODULE_SHAPE_DATA_H

#include "reading/Sequence.h"

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <pybind11/numpy.h>

#include <cstdint>

namespace Python_module {

namespace AMF = CGAL::Animated_mesh_features;

// In C order, as the package's Python files hand them over.
typedef pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast> Points_array;   // N x 3
// T x 3 or more
typedef pybind11::array_t<std::int64_t, pybind11::array::c_style | pybind11::array::forcecast> Faces_array;

// Whatever has a surface at rest.
class Shape_data
{
public:
  virtual ~Shape_data() = default;
  virtual const AMF::Rest_shape& shape() const = 0;
};

// A surface that need not move.
class Mesh_data : public Shape_data
{
public:
  // throws Input_error, as IO::to_surface_mesh() does.
  Mesh_data(const Points_array& points, const Faces_array& faces);

  const AMF::Rest_shape& shape() const override { return m_shape; }

private:
  AMF::Rest_shape m_shape;
};

} // namespace Python_module

#endif // PYTHON_MODULE_SHAPE_DATA_H
