// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind.h"

#include "Animation_data.h"
#include "Arguments.h"
#include "Detection_data.h"
#include "Python_monitor.h"
#include "feature_arrays.h"
#include "running/Thread_limit.h"

#include <CGAL/Animated_mesh_features/Animation/pose_variation.h>
#include <CGAL/Animated_mesh_features/Animation/vertex_areas.h>
#include <CGAL/Animated_mesh_features/Applications/Animation_signature.h>
#include <CGAL/Animated_mesh_features/Applications/align_animations.h>
#include <CGAL/Animated_mesh_features/Applications/align_events.h>
#include <CGAL/Animated_mesh_features/Applications/animation_distance.h>
#include <CGAL/Animated_mesh_features/Applications/classical_scaling.h>
#include <CGAL/Animated_mesh_features/Applications/event_differences.h>
#include <CGAL/Animated_mesh_features/Applications/match_aligned_features.h>
#include <CGAL/Animated_mesh_features/Descriptors/Gradient_histograms.h>
#include <CGAL/Animated_mesh_features/Descriptors/describe_features.h>
#include <CGAL/Animated_mesh_features/Descriptors/match_features.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#include <CGAL/tags.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace Python_module {

namespace {

typedef AMF::Animation_signature Signature;
typedef std::vector<AMF::Feature_point> Feature_points;

struct Match_record
{
  std::int64_t a, b;
  double confidence, difference;
};

struct Difference_record
{
  std::int64_t a, b; // none: -1
  double amplitude;
};

struct Alignment
{
  AMF::Time_alignment times;
  AMF::Event_alignment events;
};

// Tasks, such as one for each feature, of which the callable is told.
class Told_loop
{
public:
  Told_loop(Python_monitor& monitor, const char* stage)
    : m_stage(monitor, stage)
  {}

  template <class Task>
  void operator()(std::size_t number_of_tasks, const Task& task) const
  {
    Named_stage stage = m_stage;
    const AMF::Task_loop<CGAL::Parallel_if_available_tag, Named_stage> loop(stage, AMF::Stage::EXTREMA);
    loop(number_of_tasks, task);
  }

private:
  Named_stage m_stage;
};

// Computing that is no loop: the callable is asked in its middle.
template <class Task>
void run_stage(Python_monitor& monitor, const char* name, const Task& task)
{
  Named_stage stage(monitor, name);
  const AMF::Task_loop<CGAL::Sequential_tag, Named_stage> loop(stage, AMF::Stage::EXTREMA);
  loop(1, [&](std::size_t) { task(); });
}

const Programs::Values& deformation_of(const Detection_data& detection)
{
  const Programs::Values* const values = detection.field(Programs::Field::DEFORMATION);
  if (values == nullptr)
    throw AMF::Option_error(
        "the deformation was not kept, in which features are described; keep_fields=(\"deformation\",) "
        "keeps it");
  return *values;
}

// Calls `use(descriptor)` with the one that is chosen.
template <class Use>
auto with_descriptor(const Compare_animations::Settings& s, const Use& use)
{
  return s.is_oriented ? use(AMF::Oriented_gradient_histogram()) : use(AMF::Rotation_free_gradient_histogram());
}

py::array_t<float> array_of_descriptors(const AMF::Feature_descriptors& d)
{
  py::array_t<float> result({py::ssize_t(d.size()), py::ssize_t(d.length())});
  if (d.size() > 0) std::copy_n(d[0], d.size() * d.length(), result.mutable_data());
  return result;
}

py::array_t<float> descriptors(const Detection_data& detection, const Feature_array& features,
                               const Arguments& arguments, py::object visitor)
{
  const Feature_points points = features_of(features);
  Python_monitor monitor(std::move(visitor));
  return array_of_descriptors(monitor.run([&] {
    const Options o = options_of(arguments, COMPARISON);
    const Programs::Thread_limit limit(o.run.threads);
    return with_descriptor(o.comparison, [&](const auto& descriptor) {
      return AMF::describe_features(detection.shape().shape(), deformation_of(detection), detection.frame_duration(),
                                    points, descriptor, Told_loop(monitor, "descriptors"),
                                    o.comparison.activity.is_cyclic);
    });
  }));
}

std::shared_ptr<Signature> signature(const Detection_data& detection, const Feature_array& features,
                                     const Arguments& arguments, py::object visitor)
{
  const Feature_points points = features_of(features);
  Python_monitor monitor(std::move(visitor));
  return monitor.run([&] {
    const Options o = options_of(arguments, COMPARISON);
    const Programs::Thread_limit limit(o.run.threads);
    return with_descriptor(o.comparison, [&](const auto& descriptor) {
      auto result = std::make_shared<Signature>(
          AMF::animation_signature(detection.shape().shape(), deformation_of(detection), detection.frame_duration(),
                                   points, o.comparison.activity, descriptor, Told_loop(monitor, "descriptors")));
      if (detection.animation() != nullptr)
        result->activity.pose_variation = AMF::pose_variation(detection.animation()->sequence().trajectories(),
                                                              AMF::vertex_areas(detection.shape().shape()));
      return result;
    });
  });
}

std::shared_ptr<Signature> signature_of_features(const Feature_array& features, std::size_t vertices,
                                                 std::size_t frames, double frame_duration, double diagonal,
                                                 const Arguments& arguments)
{
  const Feature_points points = features_of(features);
  const py::gil_scoped_release release;
  const Options o = options_of(arguments, COMPARISON);
  return std::make_shared<Signature>(
      AMF::animation_signature(points, vertices, frames, frame_duration, diagonal, o.comparison.activity));
}

py::array_t<Match_record> array_of_matches(const std::vector<AMF::Feature_match>& matches)
{
  py::array_t<Match_record> result{py::ssize_t(matches.size())};
  Match_record* out = result.mutable_data();
  for (const AMF::Feature_match& m : matches)
    *out++ = {std::int64_t(m.a), std::int64_t(m.b), m.confidence, m.difference};
  return result;
}

py::array_t<std::int64_t> array_of_ranks(const std::vector<std::size_t>& ranks)
{
  py::array_t<std::int64_t> result{py::ssize_t(ranks.size())};
  std::copy(ranks.begin(), ranks.end(), result.mutable_data());
  return result;
}

py::array_t<Match_record> match(const Signature& a, const Signature& b, const Alignment* alignment,
                                const Arguments& arguments, py::object visitor)
{
  std::vector<AMF::Feature_match> matches;
  Python_monitor monitor(std::move(visitor));
  monitor.run([&] {
    const Options o = options_of(arguments, COMPARISON);
    run_stage(monitor, "matching", [&] {
      matches = alignment == nullptr ? AMF::match_features(a.events, b.events, o.comparison.matching)
                                     : AMF::match_aligned_features(a, b, alignment->times, o.comparison.matching);
    });
  });
  return array_of_matches(matches);
}

std::shared_ptr<Alignment> align(const Signature& a, const Signature& b, const Arguments& arguments, py::object visitor)
{
  const auto result = std::make_shared<Alignment>();
  Python_monitor monitor(std::move(visitor));
  monitor.run([&] {
    const Options o = options_of(arguments, COMPARISON);
    run_stage(monitor, "alignment", [&] {
      result->times = AMF::align_animations(a.activity, b.activity, o.comparison.alignment);
      result->events = AMF::align_events(a.events, b.events, result->times);
    });
  });
  return result;
}

py::array_t<double> distances(const std::vector<std::shared_ptr<Signature>>& signatures, const Arguments& arguments,
                              py::object visitor)
{
  const std::size_t n = signatures.size();
  std::vector<double> all(n * n, 0);
  Python_monitor monitor(std::move(visitor));
  monitor.run([&] {
    const Options o = options_of(arguments, COMPARISON);
    const Programs::Thread_limit limit(o.run.threads);
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) pairs.emplace_back(i, j);
    Told_loop(monitor, "distances")(pairs.size(), [&](std::size_t k) {
      const auto [i, j] = pairs[k];
      all[i * n + j] = all[j * n + i] =
          AMF::animation_distance(signatures[i]->activity, signatures[j]->activity, o.comparison.distance);
    });
  });
  return py::array_t<double>({py::ssize_t(n), py::ssize_t(n)}, all.data());
}

py::array_t<Difference_record> differences(const Signature& a, const Signature& b, const Alignment& alignment,
                                           double place, double profile, double frames, double factor)
{
  AMF::Event_gates gates;
  gates.place = place;
  gates.profile = profile;
  gates.frames = frames;
  gates.factor = factor;
  const std::vector<AMF::Event_difference> all = AMF::event_differences(a, b, alignment.times, gates);
  py::array_t<Difference_record> result{py::ssize_t(all.size())};
  Difference_record* out = result.mutable_data();
  for (const AMF::Event_difference& d : all)
    *out++ = {d.a ? std::int64_t(*d.a) : -1, d.b ? std::int64_t(*d.b) : -1, d.amplitude};
  return result;
}

py::array_t<double> scaling(const py::array_t<double, py::array::c_style | py::array::forcecast>& distances)
{
  const std::vector<double> all(distances.data(), distances.data() + distances.size());
  const auto places = AMF::classical_scaling(all, std::size_t(distances.ndim() > 0 ? distances.shape(0) : 0));
  py::array_t<double> result({py::ssize_t(places.size()), py::ssize_t(2)});
  double* out = result.mutable_data();
  for (const auto& p : places) out = std::copy(p.begin(), p.end(), out);
  return result;
}

template <class Number>
py::array_t<Number> array_of_elements(const std::vector<Number>& numbers)
{
  return py::array_t<Number>(py::ssize_t(numbers.size()), numbers.data());
}

} // namespace

void bind_comparison(py::module_& m)
{
  PYBIND11_NUMPY_DTYPE(Match_record, a, b, confidence, difference);
  PYBIND11_NUMPY_DTYPE(Difference_record, a, b, amplitude);
  py::class_<Signature, std::shared_ptr<Signature>>(m, "SignatureData")
      .def_readonly("number_of_vertices", &Signature::vertices)
      .def_readonly("number_of_frames", &Signature::frames)
      .def_readonly("frame_duration", &Signature::frame_duration)
      .def_readonly("bounding_box_diagonal", &Signature::diagonal)
      .def_property_readonly("features", [](const Signature& s) { return array_of_features(s.events.features); })
      .def_property_readonly("descriptors",
                             [](const Signature& s) { return array_of_descriptors(s.events.descriptors); })
      .def_property_readonly("activity", [](const Signature& s) { return array_of_elements(s.activity.mean); })
      .def_property_readonly("rate", [](const Signature& s) { return 1 / s.activity.sample_duration; })
      .def_property_readonly("is_cyclic", [](const Signature& s) { return s.activity.is_cyclic; })
      .def_property_readonly("period", [](const Signature& s) { return s.activity.cycle.period; })
      .def_property_readonly("cycle_strength", [](const Signature& s) { return s.activity.cycle.strength; })
      .def_property_readonly("pose_variation", [](const Signature& s) { return s.activity.pose_variation; });
  py::class_<Alignment, std::shared_ptr<Alignment>>(m, "AlignmentData")
      .def_property_readonly("times_a", [](const Alignment& a) { return array_of_elements(a.times.times_a); })
      .def_property_readonly("times_b", [](const Alignment& a) { return array_of_elements(a.times.times_b); })
      .def_property_readonly("cost", [](const Alignment& a) { return a.times.cost; })
      .def_property_readonly("confidence", [](const Alignment& a) { return a.times.confidence; })
      .def_property_readonly("loops",
                             [](const Alignment& a) { return std::make_pair(a.times.period_a, a.times.period_b); })
      .def_property_readonly("phase", [](const Alignment& a) { return a.times.phase; })
      .def_property_readonly("pairs", [](const Alignment& a) { return array_of_matches(a.events.pairs); })
      .def_property_readonly("only_a", [](const Alignment& a) { return array_of_ranks(a.events.only_a); })
      .def_property_readonly("only_b", [](const Alignment& a) { return array_of_ranks(a.events.only_b); })
      .def_property_readonly("score", [](const Alignment& a) { return a.events.score; })
      .def("to_a", py::vectorize([](const Alignment* a, double time) { return a->times.to_a(time); }))
      .def("to_b", py::vectorize([](const Alignment* a, double time) { return a->times.to_b(time); }));
  m.def("descriptors", &descriptors);
  m.def("signature", &signature);
  m.def("signature_of_features", &signature_of_features);
  m.def("match_features", &match);
  m.def("align", &align);
  m.def("distances", &distances);
  m.def("event_differences", &differences);
  m.def("classical_scaling", &scaling);
}

} // namespace Python_module
