// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind.h"

#include "Animation_data.h"
#include "Arguments.h"
#include "Python_monitor.h"
#include "feature_arrays.h"
#include "running/Thread_limit.h"

#include <CGAL/Animated_mesh_features/Applications/select_views.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace Python_module {

namespace {

typedef std::array<double, 3> Direction;

struct View_record
{
  Direction direction;
  double azimuth, elevation, score, covered;
  std::int64_t rank;
};

Direction coordinates(const Eigen::Vector3d& d)
{
  return {{d[0], d[1], d[2]}};
}

py::array_t<double> array_of_directions(const std::vector<Eigen::Vector3d>& directions)
{
  py::array_t<double> result({py::ssize_t(directions.size()), py::ssize_t(3)});
  double* out = result.mutable_data();
  for (const Eigen::Vector3d& d : directions) out = std::copy(d.data(), d.data() + 3, out);
  return result;
}

py::dict select_views(const Animation_data& animation, const Feature_array& features, std::optional<Direction> up,
                      std::size_t subdivisions, std::size_t refinements, std::size_t most_frames,
                      std::size_t most_views, double lowest_elevation, double highest_elevation, bool is_cyclic,
                      const Arguments& arguments, py::object visitor)
{
  const std::vector<AMF::Feature_point> points = features_of(features);
  AMF::View_options o;
  if (up) o.up = Eigen::Vector3d((*up)[0], (*up)[1], (*up)[2]);
  o.subdivisions = subdivisions;
  o.refinements = refinements;
  o.most_frames = most_frames;
  o.most_views = most_views;
  o.lowest_elevation = lowest_elevation;
  o.highest_elevation = highest_elevation;
  o.is_cyclic = is_cyclic;
  Python_monitor monitor(std::move(visitor));
  const AMF::View_selection found = monitor.run([&] {
    const Programs::Thread_limit limit(options_of(arguments, 0).run.threads);
    return AMF::select_views(animation.sequence(), points, o, monitor);
  });
  py::array_t<View_record> views{py::ssize_t(found.views.size())};
  std::transform(found.views.begin(), found.views.end(), views.mutable_data(), [](const AMF::Selected_view& v) {
    return View_record{coordinates(v.direction), v.angles.azimuth, v.angles.elevation, v.score, v.covered,
                       std::int64_t(v.rank)};
  });
  const AMF::View_scores& s = found.scores;
  const std::size_t n = s.directions().size(), frames = s.frames().size();
  py::array_t<double> scores({py::ssize_t(n), py::ssize_t(frames)});
  double* out = scores.mutable_data();
  for (std::size_t d = 0; d < n; ++d)
    for (std::size_t k = 0; k < frames; ++k) *out++ = s.score(d, k);
  py::array_t<std::int64_t> looked_at{py::ssize_t(frames)};
  std::copy(s.frames().begin(), s.frames().end(), looked_at.mutable_data());
  py::dict result;
  result["up"] = array_of_directions({found.up}).attr("reshape")(-1);
  result["views"] = views;
  result["directions"] = array_of_directions(s.directions());
  result["frames"] = looked_at;
  result["scores"] = scores;
  return result;
}

} // namespace

void bind_views(py::module_& m)
{
  PYBIND11_NUMPY_DTYPE(View_record, direction, azimuth, elevation, score, covered, rank);
  m.def("select_views", &select_views);
}

} // namespace Python_module
