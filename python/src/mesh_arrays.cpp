// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_arrays.h"

#include <CGAL/Animated_mesh_features/Animation/rest_shape_of_mesh.h>
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace py = pybind11;

namespace Python_module {

namespace {

std::string shape_text(const py::array& array)
{
  std::string text;
  for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i > 0 ? " x " : "") + std::to_string(array.shape(i));
  return text.empty() ? "a single number" : text;
}

} // namespace

template <class Point>
std::vector<Point> points_of(const Points_array& array, const std::string& what)
{
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw AMF::Input_error(what + ": vertices x 3 are expected, not " + shape_text(array));
  std::vector<Point> points;
  points.reserve(std::size_t(array.shape(0)));
  const double* p = array.data();
  for (py::ssize_t v = 0; v < array.shape(0); ++v, p += 3) {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      throw AMF::Input_error(what + ": the position of vertex " + std::to_string(v) + " is not finite");
    points.push_back(Point{p[0], p[1], p[2]});
  }
  return points;
}

template std::vector<std::array<double, 3>> points_of(const Points_array&, const std::string&);
template std::vector<AMF::Rest_shape::Point> points_of(const Points_array&, const std::string&);

std::vector<std::array<std::size_t, 3>> triangles_of(const Faces_array& array, std::size_t vertices, bool triangulate)
{
  if (array.ndim() != 2 || array.shape(1) < 3)
    throw AMF::Input_error("faces: faces x 3 are expected, not " + shape_text(array));
  const std::size_t corners = std::size_t(array.shape(1));
  if (corners > 3 && !triangulate)
    throw AMF::Input_error("faces: face 0 has " + std::to_string(corners) +
                           " corners; triangulate=True cuts such faces into triangles");
  std::vector<std::array<std::size_t, 3>> triangles;
  triangles.reserve(std::size_t(array.shape(0)) * (corners - 2));
  const std::int64_t* face = array.data();
  for (py::ssize_t f = 0; f < array.shape(0); ++f, face += corners) {
    for (std::size_t i = 0; i < corners; ++i)
      if (face[i] < 0 || std::size_t(face[i]) >= vertices)
        throw AMF::Input_error("faces: face " + std::to_string(f) + " has vertex " + std::to_string(face[i]) +
                               ", there are " + std::to_string(vertices) + " vertices, counted from 0");
    for (std::size_t i = 2; i < corners; ++i)
      triangles.push_back({{std::size_t(face[0]), std::size_t(face[i - 1]), std::size_t(face[i])}});
  }
  return triangles;
}

py::array array_of(const std::vector<AMF::Rest_shape::Triangle>& triangles)
{
  py::array_t<std::int64_t> result({py::ssize_t(triangles.size()), py::ssize_t(3)});
  std::int64_t* out = result.mutable_data();
  for (const AMF::Rest_shape::Triangle& t : triangles) out = std::copy(t.begin(), t.end(), out);
  return std::move(result);
}

py::array array_of(const std::vector<AMF::Rest_shape::Point>& points)
{
  py::array_t<double> result({py::ssize_t(points.size()), py::ssize_t(3)});
  double* out = result.mutable_data();
  for (const AMF::Rest_shape::Point& p : points) out = std::copy(p.data(), p.data() + 3, out);
  return std::move(result);
}

py::array view_of(const Programs::Values& field, const py::object& owner, bool is_shared)
{
  const py::ssize_t size = sizeof(Programs::FT);
  py::array result(py::dtype::of<Programs::FT>(),
                   {py::ssize_t(field.number_of_rows()), py::ssize_t(field.number_of_frames())},
                   {py::ssize_t(field.stride()) * size, size}, field.row(0), owner);
  if (is_shared) result.attr("flags").attr("writeable") = false;
  return result;
}

Mesh_data::Mesh_data(const Points_array& points, const Faces_array& faces)
{
  AMF::IO::Indexed_mesh mesh;
  mesh.points = points_of<std::array<double, 3>>(points, "vertices");
  mesh.triangles = triangles_of(faces, mesh.points.size(), false);
  m_shape = AMF::rest_shape_of_mesh(AMF::IO::to_surface_mesh(mesh, "faces"));
}

} // namespace Python_module
