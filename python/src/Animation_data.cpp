// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Animation_data.h"

#include "mesh_arrays.h"
#include "running/Thread_limit.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_batch.h>
#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

namespace py = pybind11;

namespace Python_module {

namespace {

typedef AMF::IO::Animation_file_data<Programs::FT> File_data;

// besides those of every detection: the deformation that a result keeps
constexpr std::size_t extra_fields = 1;

// The number may stand anywhere.
template <class T>
double number_at(const char* place)
{
  T x;
  std::memcpy(&x, place, sizeof(T));
  return double(x);
}

// Returns whether all are finite.
template <class T>
bool copy_frame(const Animation_data::Frame& frame, std::size_t vertices, double* out)
{
  double sum = 0; // x - x is 0, or NaN of what is not finite
  for (std::size_t v = 0; v < vertices; ++v) {
    const char* const point = frame.first + std::ptrdiff_t(v) * frame.of_vertex;
    for (std::ptrdiff_t i = 0; i < 3; ++i) {
      const double x = number_at<T>(point + i * frame.of_coordinate);
      sum += x - x;
      *out++ = x;
    }
  }
  return sum == 0;
}

[[noreturn]] void refuse(const double* frame, std::size_t f)
{
  std::size_t i = 0;
  while (std::isfinite(frame[i])) ++i;
  throw AMF::Input_error("frames, frame " + std::to_string(f) + ": the position of vertex " + std::to_string(i / 3) +
                         " is not finite");
}

void copy_frames(const std::vector<Animation_data::Frame>& frames, std::size_t vertices, File_data& data)
{
  AMF::Frame_batch<double, CGAL::Parallel_if_available_tag> batch({{&data.x, &data.y, &data.z}}, 8);
  for (std::size_t first = 0; first < frames.size();) {
    const std::size_t end = batch.end();
    std::atomic<std::size_t> bad(frames.size());
    AMF::parallel_for<CGAL::Parallel_if_available_tag>(first, end, [&](std::size_t f) {
      const bool is_good = frames[f].is_single ? copy_frame<float>(frames[f], vertices, batch.frame(f))
                                               : copy_frame<double>(frames[f], vertices, batch.frame(f));
      if (is_good) return;
      std::size_t other = bad.load();
      while (f < other && !bad.compare_exchange_weak(other, f)) {}
    });
    if (bad < frames.size()) refuse(batch.frame(bad), bad);
    if (first == 0)
      for (std::size_t v = 0; v < vertices; ++v) {
        const double* const p = batch.frame(0) + 3 * v;
        data.mesh.points.push_back({{p[0], p[1], p[2]}});
      }
    batch.finish();
    first = end;
  }
}

} // namespace

Animation_data::Animation_data(Options options, const std::vector<std::string>& inputs)
  : m_reading(std::move(options.reading))
  , m_plan(options.run.memory,
           options.run.scratch_directory.empty() ? Programs::default_scratch_directory() : options.run.scratch_directory)
  , m_threads(options.run.threads)
{
  m_reading.inputs = inputs;
}

Animation_data::Animation_data(const std::vector<std::string>& inputs, const Arguments& arguments,
                               Python_monitor& monitor)
  : Animation_data(options_of(arguments, READING), inputs)
{
  check(m_reading);
  const Programs::Thread_limit limit(m_threads);
  m_animation = std::make_unique<Programs::Animation>(m_reading, [&](std::size_t vertices, std::size_t frames) {
    m_input_vertices = vertices;
    return m_plan.decide(vertices, frames, extra_fields);
  }, monitor);
  m_plan.refine(shape());
}

Animation_data::Animation_data(const std::vector<Frame>& frames, std::size_t vertices, const Faces_array& faces,
                               const Points_array& rest, const Arguments& arguments, Python_monitor& monitor)
  : Animation_data(options_of(arguments, READING), {"faces", "frames"})
{
  if (rest.size() > 0) m_reading.rest.kind = Programs::Rest::FILE; // as good as one
  check(m_reading);
  m_reading.rest.kind = rest.size() > 0 ? Programs::Rest::BY_INPUT : m_reading.rest.kind;
  const Programs::Thread_limit limit(m_threads);
  m_input_vertices = vertices;
  if (frames.size() < 3)
    throw AMF::Input_error("frames: the animation has " + std::to_string(frames.size()) +
                           " frames; at least 3 are needed, since a feature has a frame before and one after it");
  File_data data;
  data.sources = m_reading.inputs;
  data.frames = frames.size();
  data.mesh.triangles = triangles_of(faces, vertices, m_reading.triangulate);
  Programs::Rest_points points;
  if (rest.size() > 0) {
    points = points_of<AMF::Rest_shape::Point>(rest, "rest");
    if (points.size() != vertices)
      throw AMF::Input_error("rest: has " + std::to_string(points.size()) + " vertices, the frames have " +
                             std::to_string(vertices));
  }
  const std::shared_ptr<AMF::Field_memory> memory = m_plan.decide(vertices, frames.size(), extra_fields);
  for (Programs::Values* c : {&data.x, &data.y, &data.z}) *c = Programs::Values(vertices, frames.size(), memory);
  copy_frames(frames, vertices, data);
  m_animation = std::make_unique<Programs::Animation>(m_reading, std::move(data), points, monitor);
  m_plan.refine(shape());
}

} // namespace Python_module
