// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind.h"

#include "Animation_data.h"
#include "Python_monitor.h"
#include "Shape_data.h"
#include "mesh_arrays.h"

#include <CGAL/Animated_mesh_features/Animation/vertex_areas.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace py = pybind11;

namespace Python_module {

namespace {

// F x N x 3, or a list of N x 3: as the Python file has checked.
std::shared_ptr<Animation_data> of_arrays(const std::vector<py::array>& arrays, const Faces_array& faces,
                                          const Points_array& rest, const Arguments& arguments, py::object visitor)
{
  std::vector<Animation_data::Frame> frames;
  std::size_t vertices = 0;
  for (const py::array& a : arrays) {
    const bool is_block = a.ndim() == 3;
    const py::ssize_t first_axis = is_block ? 1 : 0;
    vertices = std::size_t(a.shape(first_axis));
    for (py::ssize_t f = 0; f < (is_block ? a.shape(0) : 1); ++f)
      frames.push_back({static_cast<const char*>(a.data()) + (is_block ? f * a.strides(0) : 0), a.strides(first_axis),
                        a.strides(first_axis + 1), a.itemsize() == 4});
  }
  Python_monitor monitor(std::move(visitor));
  return monitor.run(
      [&] { return std::make_shared<Animation_data>(frames, vertices, faces, rest, arguments, monitor); });
}

std::shared_ptr<Animation_data> of_files(const std::vector<std::string>& inputs, const Arguments& arguments,
                                         py::object visitor)
{
  Python_monitor monitor(std::move(visitor));
  return monitor.run([&] { return std::make_shared<Animation_data>(inputs, arguments, monitor); });
}

py::array trajectories(const py::object& self, std::size_t axis)
{
  const auto& t = self.cast<const Animation_data&>().sequence().trajectories();
  return view_of(axis == 0 ? t.x : axis == 1 ? t.y : t.z, self);
}

// F x N x 3
py::array positions(const Animation_data& a)
{
  const auto& t = a.sequence().trajectories();
  const py::ssize_t frames = py::ssize_t(a.sequence().number_of_frames()),
                    vertices = py::ssize_t(a.sequence().number_of_vertices());
  py::array_t<double> result({frames, vertices, py::ssize_t(3)});
  double* const out = result.mutable_data();
  for (py::ssize_t v = 0; v < vertices; ++v)
    for (py::ssize_t f = 0; f < frames; ++f) {
      double* const p = out + 3 * (f * vertices + v);
      p[0] = t.x(std::size_t(v), std::size_t(f));
      p[1] = t.y(std::size_t(v), std::size_t(f));
      p[2] = t.z(std::size_t(v), std::size_t(f));
    }
  return std::move(result);
}

// For each vertex of the input its vertex here; -1 if it has none.
py::array vertex_of_input(const Animation_data& a)
{
  py::array_t<std::int64_t> result{py::ssize_t(a.number_of_input_vertices())};
  std::int64_t* const out = result.mutable_data();
  const AMF::IO::Vertex_origins& origins = a.animation().origins();
  for (std::size_t i = 0; i < a.number_of_input_vertices(); ++i) out[i] = origins.empty() ? std::int64_t(i) : -1;
  for (std::size_t v = 0; v < origins.number_of_vertices(); ++v)
    for (std::size_t i : origins.of(v))
      if (i < a.number_of_input_vertices()) out[i] = std::int64_t(v);
  return std::move(result);
}

} // namespace

void bind_animation(py::module_& m)
{
  py::class_<Shape_data, std::shared_ptr<Shape_data>>(m, "ShapeData")
      .def_property_readonly("vertices", [](const Shape_data& s) { return array_of(s.shape().points()); })
      .def_property_readonly("faces", [](const Shape_data& s) { return array_of(s.shape().triangles()); })
      .def_property_readonly("diameter", [](const Shape_data& s) { return s.shape().diameter(); })
      .def_property_readonly("bounding_box_diagonal",
                             [](const Shape_data& s) { return s.shape().bounding_box_diagonal(); })
      .def_property_readonly("mean_edge_length", [](const Shape_data& s) { return s.shape().mean_edge_length(); })
      .def_property_readonly("areas", [](const Shape_data& s) {
        const std::vector<double> areas = AMF::vertex_areas(s.shape());
        return py::array_t<double>(py::ssize_t(areas.size()), areas.data());
      });
  py::class_<Mesh_data, Shape_data, std::shared_ptr<Mesh_data>>(m, "MeshData")
      .def(py::init<const Points_array&, const Faces_array&>());
  py::class_<Animation_data, Shape_data, std::shared_ptr<Animation_data>>(m, "AnimationData")
      .def("trajectories", &trajectories)
      .def_property_readonly("positions", &positions)
      .def_property_readonly("vertex_of_input", &vertex_of_input)
      .def_property_readonly("number_of_frames",
                             [](const Animation_data& a) { return a.sequence().number_of_frames(); })
      .def_property_readonly("number_of_vertices",
                             [](const Animation_data& a) { return a.sequence().number_of_vertices(); })
      .def_property_readonly("fps", [](const Animation_data& a) { return a.animation().frames_per_second(); })
      .def_property_readonly("frame_duration", [](const Animation_data& a) { return a.sequence().frame_duration(); })
      .def_property_readonly("notices", [](const Animation_data& a) { return a.animation().notices(); })
      .def_property_readonly("remarks", [](const Animation_data& a) { return a.animation().remarks(); })
      .def_property_readonly("clips", [](const Animation_data& a) { return a.animation().clips(); })
      .def_property_readonly("clip", [](const Animation_data& a) { return a.animation().clip_name(); })
      .def_property_readonly("files", [](const Animation_data& a) { return a.animation().files(); })
      .def_property_readonly("rest", [](const Animation_data& a) { return a.animation().rest().text; })
      .def_property_readonly("rest_name", [](const Animation_data& a) { return a.animation().rest().name; })
      .def_property_readonly("rest_factor", [](const Animation_data& a) { return a.animation().rest().factor; });
  m.def("animation_of_arrays", &of_arrays);
  m.def("animation_of_files", &of_files);
}

} // namespace Python_module
