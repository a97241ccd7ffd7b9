// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind.h"

#include "Shape_data.h"
#include "mesh_arrays.h"

#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/IO/write_obj.h>
#include <CGAL/Animated_mesh_features/IO/write_point_cache.h>

#include <pybind11/numpy.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace py = pybind11;

namespace Python_module {

namespace {

typedef py::array_t<float, py::array::c_style> Frame_array; // N x 3

// A mesh (.obj) and a point cache (.pc2, or .mdd if `is_mdd`), both or none; `frame_of(f)` returns the positions of a frame.
void write_animation(const std::string& mesh_name, const std::string& cache_name, bool is_mdd, const Points_array& rest,
                     const Faces_array& faces, std::size_t frames, double frame_duration, const py::function& frame_of)
{
  AMF::IO::Indexed_mesh mesh;
  mesh.points = points_of<std::array<double, 3>>(rest, "rest");
  mesh.triangles = triangles_of(faces, mesh.points.size(), false);
  AMF::IO::Output_file mesh_file(mesh_name), cache(cache_name);
  AMF::IO::write_obj(mesh_file.stream(), mesh);
  mesh_file.check();
  const std::size_t n = mesh.points.size();
  const auto fill = [&](std::size_t f, float* xyz) {
    const auto positions = frame_of(f).cast<Frame_array>();
    std::copy(positions.data(), positions.data() + 3 * n, xyz);
  };
  if (is_mdd) {
    std::vector<float> times;
    for (std::size_t f = 0; f < frames; ++f) times.push_back(float(double(f) * frame_duration));
    AMF::IO::write_mdd(cache.stream(), n, times, fill);
  } else {
    AMF::IO::write_pc2(cache.stream(), n, frames, fill);
  }
  cache.check();
  mesh_file.commit();
  cache.commit();
}

} // namespace

void bind_writing(py::module_& m)
{
  m.def("write_animation", &write_animation);
}

} // namespace Python_module
