// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind.h"

#include "Simplification_data.h"
#include "feature_arrays.h"
#include "mesh_arrays.h"

#include <CGAL/Animated_mesh_features/Applications/simplification_errors.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace Python_module {

namespace {

struct Error_record
{
  std::int64_t frame;
  double mean_to_original, mean_to_coarse, max_to_original, max_to_coarse, normal_angle, mean_in_regions,
      mean_elsewhere, share_in_regions;
  std::int64_t turned;
};

std::shared_ptr<Simplification_data> simplify(std::shared_ptr<Animation_data> animation, const Feature_array& features,
                                              const Arguments& arguments, bool is_measured, py::object visitor)
{
  const std::vector<AMF::Feature_point> points = features_of(features);
  Python_monitor monitor(std::move(visitor));
  return monitor.run([&] {
    return std::make_shared<Simplification_data>(std::move(animation), points, arguments, is_measured, monitor);
  });
}

// The matrix of a binding as SciPy has it: values, columns, and where rows begin.
py::tuple compressed_rows(const AMF::Vertex_binding& binding)
{
  const std::size_t rows = binding.size();
  py::array_t<std::int64_t> begins{py::ssize_t(rows + 1)};
  std::int64_t* const begin = begins.mutable_data();
  begin[0] = 0;
  for (std::size_t v = 0; v < rows; ++v) begin[v + 1] = begin[v] + std::int64_t(binding.vertices(v).size());
  py::array_t<double> values{py::ssize_t(begin[rows])};
  py::array_t<std::int64_t> columns{py::ssize_t(begin[rows])};
  double* value = values.mutable_data();
  std::int64_t* column = columns.mutable_data();
  for (std::size_t v = 0; v < rows; ++v) {
    value = std::copy(binding.weights(v).begin(), binding.weights(v).end(), value);
    column = std::copy(binding.vertices(v).begin(), binding.vertices(v).end(), column);
  }
  return py::make_tuple(values, columns, begins);
}

py::array vertex_of(const AMF::Animation_level& level)
{
  py::array_t<std::int64_t> result{py::ssize_t(level.vertex_of.size())};
  std::transform(level.vertex_of.begin(), level.vertex_of.end(), result.mutable_data(),
                 [](AMF::Rest_shape::Index v) { return v == AMF::Rest_shape::none ? -1 : std::int64_t(v); });
  return std::move(result);
}

py::object level_errors(const Simplification_data& s, std::size_t level)
{
  if (s.report().levels.empty()) return py::none();
  const std::vector<AMF::Simplification_error>& frames = s.report().levels.at(level).frames;
  py::array_t<Error_record> result{py::ssize_t(frames.size())};
  std::transform(frames.begin(), frames.end(), result.mutable_data(), [](const AMF::Simplification_error& e) {
    return Error_record{std::int64_t(e.frame), e.mean_to_original,    e.mean_to_coarse,  e.max_to_original,
                        e.max_to_coarse,       e.normal_angle,        e.mean_in_regions, e.mean_elsewhere,
                        e.share_in_regions,    std::int64_t(e.turned)};
  });
  return std::move(result);
}

} // namespace

void bind_simplification(py::module_& m)
{
  PYBIND11_NUMPY_DTYPE(Error_record, frame, mean_to_original, mean_to_coarse, max_to_original, max_to_coarse,
                       normal_angle, mean_in_regions, mean_elsewhere, share_in_regions, turned);
  py::class_<Simplification_data, std::shared_ptr<Simplification_data>>(m, "SimplificationData")
      .def_property_readonly("number_of_levels", [](const Simplification_data& s) { return s.result().levels.size(); })
      .def_property_readonly("poses", [](const Simplification_data& s) { return s.result().poses; })
      .def_property_readonly("report", [](const Simplification_data& s) { return json_of(s.report()).dump(); })
      .def_property_readonly("table", [](const Simplification_data& s) { return text_of(s.report()); })
      .def("vertices", [](const Simplification_data& s, std::size_t i) { return array_of(s.points(i)); })
      .def("faces", [](const Simplification_data& s, std::size_t i) { return array_of(s.level(i).triangles); })
      .def("binding", [](const Simplification_data& s, std::size_t i) { return compressed_rows(s.level(i).binding); })
      .def("vertex_of", [](const Simplification_data& s, std::size_t i) { return vertex_of(s.level(i)); })
      .def("errors", &level_errors);
  m.def("simplify", &simplify);
}

} // namespace Python_module
