// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind.h"

#include "Detection_data.h"
#include "feature_arrays.h"
#include "mesh_arrays.h"

#include "evaluate_features/Feature_file.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace py = pybind11;
using Programs::Field;
using Programs::Values;

namespace Python_module {

namespace {

typedef std::vector<std::string> Names;

Field field_of(const std::string& text)
{
  return Programs::chosen<Field>("fields", text);
}

std::shared_ptr<Detection_data> detect(std::shared_ptr<Animation_data> animation, const Arguments& arguments,
                                       const Names& kept, py::object visitor)
{
  std::set<Field> kinds;
  for (const std::string& text : kept) kinds.insert(field_of(text));
  Python_monitor monitor(std::move(visitor));
  return monitor.run([&] {
    return std::make_shared<Detection_data>(std::move(animation), arguments, std::move(kinds), monitor);
  });
}

// Of an array N x F of float32 or float64, whatever its strides.
Values values_of(const py::array& array)
{
  Values values(std::size_t(array.shape(0)), std::size_t(array.shape(1)));
  const auto copy = [&](auto number) {
    typedef decltype(number) T;
    const auto in = array.unchecked<T, 2>();
    for (py::ssize_t v = 0; v < in.shape(0); ++v)
      for (py::ssize_t f = 0; f < in.shape(1); ++f) values(std::size_t(v), std::size_t(f)) = double(in(v, f));
  };
  if (array.itemsize() == 4)
    copy(float());
  else
    copy(double());
  return values;
}

std::shared_ptr<Detection_data> detect_in_field(std::shared_ptr<Shape_data> shape, const py::array& array,
                                                double frame_duration, double noise, const Arguments& arguments,
                                                py::object visitor)
{
  Values field = values_of(array);
  Python_monitor monitor(std::move(visitor));
  return monitor.run([&] {
    return std::make_shared<Detection_data>(std::move(shape), std::move(field), frame_duration, noise, arguments,
                                            monitor);
  });
}

// A field that is nobody else's.
py::array handed_over(Values&& field)
{
  auto owned = std::make_unique<Values>(std::move(field));
  const Values& values = *owned;
  const py::capsule owner(owned.get(), [](void* v) { delete static_cast<Values*>(v); });
  owned.release();
  return view_of(values, owner, false);
}

py::array measure(const Animation_data& animation, const std::string& kind, const Arguments& arguments,
                  py::object visitor)
{
  const Field field = field_of(kind);
  Python_monitor monitor(std::move(visitor));
  return handed_over(monitor.run([&] { return measured_field(animation, field, arguments, monitor); }));
}

template <class Container>
py::array array_of_numbers(const Container& numbers)
{
  typedef typename Container::value_type T;
  return py::array_t<T>(py::ssize_t(numbers.size()), numbers.data());
}

// As SciPy's sparse matrices have it: where rows begin, and what is in them.
py::tuple balls(const Shape_data& shape, const Arguments& arguments, py::object visitor)
{
  Python_monitor monitor(std::move(visitor));
  const AMF::Compressed_rows rows = monitor.run([&] { return geodesic_balls(shape, arguments, monitor); });
  py::array_t<std::int64_t> offsets{py::ssize_t(rows.size() + 1)};
  std::int64_t* const begin = offsets.mutable_data();
  begin[0] = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) begin[i + 1] = begin[i] + std::int64_t(rows[i].size());
  const AMF::Compressed_rows::Index* const first = rows.size() > 0 ? rows[0].begin() : nullptr;
  return py::make_tuple(offsets, py::array_t<std::uint32_t>(py::ssize_t(rows.number_of_entries()), first));
}

py::object object_of(const AMF::IO::Result_description::Value& value)
{
  return std::visit(
      [](const auto& v) -> py::object {
        if constexpr (std::is_same<std::decay_t<decltype(v)>, std::monostate>::value)
          return py::none();
        else
          return py::cast(v);
      },
      value);
}

py::dict dictionary_of(const AMF::IO::Result_description& d)
{
  py::dict animation, parameters, result;
  animation["vertices"] = d.vertices;
  animation["faces"] = d.faces;
  animation["frames"] = d.frames;
  animation["frame_duration"] = d.frame_duration;
  animation["bounding_box_diagonal"] = d.bounding_box_diagonal;
  animation["mean_edge_length"] = d.mean_edge_length;
  for (const auto& p : d.parameters) parameters[py::str(p.first)] = object_of(p.second);
  result["animation"] = animation;
  result["parameters"] = parameters;
  return result;
}

py::dict read_features(const std::string& path)
{
  const Evaluate_features::Feature_file file(path);
  py::dict result = dictionary_of(file.data.description);
  result["features"] = array_of_features(file.features());
  if (!file.data.file_vertices.empty()) result["file_vertices"] = py::cast(file.data.file_vertices);
  return result;
}

py::object field(const py::object& self, const std::string& kind)
{
  const Values* const values = self.cast<const Detection_data&>().field(field_of(kind));
  if (values == nullptr) return py::none();
  return view_of(*values, self);
}

} // namespace

void bind_detection(py::module_& m)
{
  py::class_<Detection_data, std::shared_ptr<Detection_data>>(m, "DetectionData")
      .def_property_readonly("features",
                             [](const Detection_data& d) { return array_of_features(d.detection().features); })
      .def("field", &field)
      .def("write", &Detection_data::write, py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("description", [](const Detection_data& d) { return dictionary_of(d.description()); })
      .def_property_readonly("reason", &Detection_data::reason)
      .def_property_readonly("number_of_minima",
                             [](const Detection_data& d) { return d.detection().number_of_minima; })
      .def_property_readonly("sigma_levels",
                             [](const Detection_data& d) { return array_of_numbers(d.detection().scales.sigma_levels); })
      .def_property_readonly("tau_levels",
                             [](const Detection_data& d) { return array_of_numbers(d.detection().scales.tau_levels); })
      .def_property_readonly("ball_radius", [](const Detection_data& d) { return d.detection().ball_radius; });
  m.def("detect", &detect);
  m.def("detect_in_field", &detect_in_field);
  m.def("measure", &measure);
  m.def("geodesic_balls", &balls);
  m.def("read_features", &read_features);
}

} // namespace Python_module
