// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind.h"

#include "Shape_data.h"
#include "feature_arrays.h"

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Evaluation/Placed_feature.h>
#include <CGAL/Animated_mesh_features/Evaluation/Random_numbers.h>
#include <CGAL/Animated_mesh_features/Evaluation/Rig_events.h>
#include <CGAL/Animated_mesh_features/Evaluation/bootstrap_interval.h>
#include <CGAL/Animated_mesh_features/Evaluation/chance_level.h>
#include <CGAL/Animated_mesh_features/Evaluation/feature_regions.h>
#include <CGAL/Animated_mesh_features/Evaluation/map_scores.h>
#include <CGAL/Animated_mesh_features/Evaluation/matching_errors.h>
#include <CGAL/Animated_mesh_features/Evaluation/paired_features.h>
#include <CGAL/Animated_mesh_features/Evaluation/prominent_maxima.h>
#include <CGAL/Animated_mesh_features/Evaluation/repeated_features.h>
#include <CGAL/Animated_mesh_features/IO/read_painting.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace Python_module {

namespace {

typedef AMF::Spatio_temporal_field<float> Map;
typedef py::array_t<float, py::array::c_style | py::array::forcecast> Map_array; // N x F
typedef py::array_t<double, py::array::c_style | py::array::forcecast> Numbers;

py::array_t<double> array_of(const std::vector<double>& numbers)
{
  return py::array_t<double>(py::ssize_t(numbers.size()), numbers.data());
}

std::vector<double> numbers_of(const Numbers& array)
{
  return std::vector<double>(array.data(), array.data() + array.size());
}

// Of `at_rest` on the rest shape, else where they are in space.
std::vector<AMF::Placed_feature> placed(const Feature_array& array, bool at_rest)
{
  std::vector<AMF::Placed_feature> result;
  for (const AMF::Feature_point& f : features_of(array)) {
    const std::array<double, 3>& p = at_rest ? f.rest_position : f.position;
    result.push_back({AMF::Rest_shape::Point(p[0], p[1], p[2]), f.time, f.sigma, f.tau});
  }
  return result;
}

std::vector<AMF::Feature_on_shape> on_shape(const Feature_array& array, const AMF::Rest_shape& shape)
{
  std::vector<AMF::Feature_on_shape> result;
  for (const AMF::Feature_point& f : features_of(array)) {
    // before it is narrowed
    if (f.vertex_index >= shape.number_of_vertices())
      throw AMF::Input_error("a feature is at vertex " + std::to_string(f.vertex_index) + ", the rest shape has " +
                             std::to_string(shape.number_of_vertices()) + " vertices");
    result.push_back({AMF::Rest_shape::Index(f.vertex_index), f.time});
  }
  return result;
}

std::pair<py::array, py::array> repeated(const Feature_array& a, const Feature_array& b, std::size_t top,
                                         std::size_t among, double place, double time, double factor, bool at_rest)
{
  const AMF::Repeated_features r =
      AMF::repeated_features(placed(a, at_rest), placed(b, at_rest), top, among, {place, time, factor});
  return {array_of(r.in_place_and_time), array_of(r.with_scales)};
}

std::pair<py::array, py::array> paired(const Feature_array& a, const Feature_array& b, double place, double time,
                                       double factor, bool at_rest)
{
  const AMF::Paired_features p = AMF::paired_features(placed(a, at_rest), placed(b, at_rest), {place, time, factor});
  return {array_of(p.in_place_and_time), array_of(p.with_scales)};
}

py::array errors(const Shape_data& shape, const Feature_array& features, const Feature_array& others, double time)
{
  const auto a = on_shape(features, shape.shape()), b = on_shape(others, shape.shape());
  std::vector<double> result;
  {
    py::gil_scoped_release release;
    result = time < 0 ? AMF::matching_errors(shape.shape(), a, b) : AMF::matching_errors(shape.shape(), a, b, time);
  }
  return array_of(result);
}

py::array regions(const Shape_data& shape, const Feature_array& array, std::size_t frames, double frame_duration,
                  bool is_gaussian)
{
  const std::vector<AMF::Feature_point> features = features_of(array);
  std::unique_ptr<Map> map;
  {
    py::gil_scoped_release release;
    map = std::make_unique<Map>(
        AMF::feature_regions(shape.shape(), frames, frame_duration, features,
                             is_gaussian ? AMF::Region_course::GAUSSIAN : AMF::Region_course::PRESENT));
  }
  const Map& values = *map;
  const py::ssize_t size = sizeof(float);
  const py::capsule owner(map.get(), [](void* v) { delete static_cast<Map*>(v); });
  map.release();
  return py::array(py::dtype::of<float>(), {py::ssize_t(values.number_of_rows()), py::ssize_t(frames)},
                   {py::ssize_t(values.stride()) * size, size}, values.row(0), owner);
}

Map map_of(const Map_array& array)
{
  if (array.ndim() != 2) throw AMF::Option_error("a map is vertices x frames");
  Map map(std::size_t(array.shape(0)), std::size_t(array.shape(1)));
  for (py::ssize_t v = 0; v < array.shape(0); ++v)
    std::copy(array.data(v, 0), array.data(v, 0) + array.shape(1), map.row(std::size_t(v)));
  return map;
}

std::tuple<double, double, double> scores(const Map_array& map, const Map_array& marks, const Numbers& areas)
{
  const AMF::Map_scores s = AMF::map_scores(map_of(map), map_of(marks), numbers_of(areas));
  return {s.auc, s.nss, s.correlation};
}

std::pair<double, double> interval(const Numbers& sample, const py::object& statistic, std::size_t resamples,
                                   double confidence, std::uint64_t seed)
{
  const AMF::Bootstrap_options options = {resamples, confidence, seed};
  const AMF::Interval i =
      statistic.is_none()
          ? AMF::bootstrap_interval(numbers_of(sample), options)
          : AMF::bootstrap_interval(
                numbers_of(sample),
                [&](const std::vector<double>& drawn) { return statistic(array_of(drawn)).cast<double>(); }, options);
  return {i.low, i.high};
}

// Where and when features are by chance: draws x features.
std::pair<py::array, py::array> random_places(std::size_t features, std::size_t vertices, double duration,
                                              std::size_t draws, std::uint64_t seed)
{
  const std::vector<py::ssize_t> shape = {py::ssize_t(draws), py::ssize_t(features)};
  py::array_t<std::int64_t> where(shape);
  py::array_t<double> when(shape);
  std::int64_t* v = where.mutable_data();
  double* t = when.mutable_data();
  AMF::chance_level(
      features, vertices, duration,
      [&](const std::vector<AMF::Random_place>& places) {
        for (const AMF::Random_place& p : places) {
          *v++ = std::int64_t(p.vertex);
          *t++ = p.time;
        }
        return 0.;
      },
      {draws, seed});
  return {where, when};
}

std::vector<std::tuple<std::size_t, double, double>> maxima(const Numbers& series, double least)
{
  std::vector<std::tuple<std::size_t, double, double>> result;
  for (const AMF::Prominent_maximum& m : AMF::prominent_maxima(numbers_of(series), least))
    result.emplace_back(m.place, m.value, m.prominence);
  return result;
}

// (found, at event, number for each joint, the events that should be found: joint, time)
py::tuple rig(const Points_array& points, double size, const std::vector<std::vector<std::uint32_t>>& regions,
              const std::vector<std::tuple<std::size_t, double, double, double>>& events, std::size_t frames,
              double frame_duration, const Feature_array& features, const AMF::Rig_options& options)
{
  std::vector<AMF::Rest_shape::Point> positions;
  for (py::ssize_t v = 0; v < points.shape(0); ++v)
    positions.emplace_back(points.at(v, 0), points.at(v, 1), points.at(v, 2));
  std::vector<AMF::Joint_event> moments;
  for (const auto& [joint, time, angle, prominence] : events) moments.push_back({joint, time, angle, prominence});
  std::vector<AMF::Rig_feature> where;
  for (const AMF::Feature_point& f : features_of(features)) where.push_back({f.vertex_index, f.time, f.sigma, f.tau});
  const AMF::Rig_events truth(positions, size, regions, moments, frames, frame_duration, options);
  const AMF::Rig_matches matches = truth(where);
  std::vector<std::pair<std::size_t, double>> recalled;
  for (const AMF::Joint_event& e : truth.recalled()) recalled.emplace_back(e.joint, e.time);
  return py::make_tuple(array_of(matches.found), array_of(matches.at_event), matches.of_joint, recalled);
}

py::dict painting(const std::string& path)
{
  const AMF::IO::Painting_file_data data = AMF::IO::read_painting(path);
  py::list strokes;
  for (const AMF::IO::Painting_file_data::Stroke& s : data.strokes) {
    py::array_t<std::int64_t> vertices{py::ssize_t(s.vertices.size())};
    std::copy(s.vertices.begin(), s.vertices.end(), vertices.mutable_data());
    strokes.append(py::make_tuple(s.first_frame, s.last_frame, vertices));
  }
  py::dict result;
  result["painter"] = data.painter;
  result["strokes"] = strokes;
  result["vertices"] = data.vertices;
  result["frames"] = data.frames;
  result["frame_duration"] = data.frame_duration;
  return result;
}

} // namespace

void bind_evaluation(py::module_& m)
{
  m.def("repeated_features", &repeated);
  m.def("paired_features", &paired);
  m.def("matching_errors", &errors);
  m.def("feature_regions", &regions);
  m.def("map_scores", &scores);
  m.def("bootstrap_interval", &interval);
  m.def("random_places", &random_places);
  m.def("read_painting", &painting);
  m.def("prominent_maxima", &maxima);
  py::class_<AMF::Rig_options>(m, "RigOptions")
      .def(py::init<>())
      .def_readwrite("least_prominence", &AMF::Rig_options::least_prominence)
      .def_readwrite("least_angle", &AMF::Rig_options::least_angle)
      .def_readwrite("least_recalled_angle", &AMF::Rig_options::least_recalled_angle)
      .def_readwrite("largest_distance", &AMF::Rig_options::largest_distance)
      .def_readwrite("frames", &AMF::Rig_options::frames)
      .def_readwrite("share_of_tau", &AMF::Rig_options::share_of_tau);
  m.def("rig_matches", &rig);
}

} // namespace Python_module
