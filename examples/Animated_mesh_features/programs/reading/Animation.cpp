// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Animation.h"

#include "reading/Model_file.h"
#include "reading/denoise.h"
#include "reading/keep_frames.h"

#include <CGAL/Animated_mesh_features/IO/check_frames.h>
#include <CGAL/Animated_mesh_features/IO/read_animation.h>
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>
#include <CGAL/Animated_mesh_features/IO/weld_part.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

typedef AMF::IO::Animation_file_data<FT> File_data;

const double default_frames_per_second = 30;

void check_options(const Reading_options& o, Model_format format)
{
  const bool is_model = format == Model_format::GLTF || format == Model_format::ASSIMP;
  if (o.clip_frames && !is_model)
    throw AMF::Option_error(
        "--frames goes with an animated model, of which frames are made; other inputs have their own");
  if (o.there_and_back && !is_model)
    throw AMF::Option_error("--there-and-back goes with an animated model, of which frames are made");
  if (o.clip_frames && *o.clip_frames < 3) throw AMF::Option_error("--frames: at least 3 are needed");
  if (o.as_given && o.inputs.size() < 2)
    throw AMF::Option_error("--as-given goes with a mesh for each frame, which stand in their order");
  if (!o.clip.empty() && format == Model_format::NONE)
    throw AMF::Option_error("--clip goes with a file that holds several animations: an animated model, or HDF5");
  if (is_model && (o.weld != Weld::AUTO || o.repair))
    throw AMF::Option_error("--weld and --repair go with meshes; models are welded and mended in any case");
  if (!o.faces_dataset.empty() && format != Model_format::HDF5)
    throw AMF::Option_error("--faces goes with an HDF5 file");
}

// The time between frames, from the time of each frame.
double frame_duration(const std::vector<double>& times, const std::string& file)
{
  std::vector<double> steps;
  for (std::size_t f = 1; f < times.size(); ++f) steps.push_back(times[f] - times[f - 1]);
  std::vector<double> sorted = steps;
  std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  // Times are stored in single precision: late ones are rounded by 6e-8 of themselves.
  const double tolerance = 0.01 * usual + 1e-6 * (std::max)(std::abs(times.front()), std::abs(times.back()));
  const std::string remedy = "; --fps takes the frames as equidistant";
  if (!(usual > 0)) throw AMF::Input_error(file + ": the times of the frames do not increase" + remedy);
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (!(std::abs(steps[i] - usual) <= tolerance))
      throw AMF::Input_error(file + ": frame " + std::to_string(i + 1) + " is " + std::to_string(steps[i]) +
                             " s after the one before, others are " + std::to_string(usual) +
                             " s: the frames must be equidistant" + remedy);
  return (times.back() - times.front()) / double(steps.size());
}

std::string number(double x)
{
  std::ostringstream os;
  os << x;
  return os.str();
}

double frames_per_second(const Reading_options& o, const File_data& data)
{
  if (o.frames_per_second) return *o.frames_per_second;
  return data.times.empty() ? default_frames_per_second : 1 / frame_duration(data.times, data.sources.back());
}

// Times that are frame numbers make an animation last too long.
void add_notice_of_slow_frames(const Reading_options& o, double frames_per_second, const File_data& data,
                               std::vector<std::string>& notices)
{
  const double usually_faster = 5;
  if (o.frames_per_second || data.times.empty() || frames_per_second >= usually_faster) return;
  std::ostringstream os;
  os << data.sources.back() << ": its times tell a frame rate of " << frames_per_second
     << " a second; if they are numbers of frames instead of seconds, tell the rate by --fps";
  notices.push_back(os.str());
}

// of the clip that was read, or of several together: as --clip takes it
std::string clip_name(const File_data& data)
{
  if (data.clips.empty()) return std::string();
  const auto name = [&](std::size_t clip) {
    const std::string& n = data.clips[clip];
    const bool is_unique = std::count(data.clips.begin(), data.clips.end(), n) == 1;
    const bool is_split = !data.further_clips.empty() && n.find('+') != std::string::npos;
    return n.empty() || !is_unique || is_split ? std::to_string(clip) : n;
  };
  std::string all = name(data.clip);
  for (std::size_t clip : data.further_clips) all += "+" + name(clip);
  return all;
}

// Fourth powers of lengths, the squares of areas, must be numbers.
void check_size(const Sequence& sequence, const std::string& frame)
{
  const double largest = 1e70, smallest = 1e-70;
  const std::vector<AMF::Rest_shape::Point>& points = sequence.rest_shape().points();
  double extent = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!(points[v].cwiseAbs().maxCoeff() <= largest))
      throw AMF::Input_error(frame + ": a coordinate of vertex " + std::to_string(v) + " is " +
                             number(points[v].cwiseAbs().maxCoeff()) + "; above " + number(largest) +
                             " nothing can be computed: another unit of length is needed");
    extent = (std::max)(extent, (points[v] - points[0]).cwiseAbs().maxCoeff());
  }
  if (extent > 0 && extent < smallest)
    throw AMF::Input_error(frame + ": the surface is only " + number(extent) + " large; below " + number(smallest) +
                           " nothing can be computed: another unit of length is needed");
}

// Which vertices default lengths are measured by is surprising if it is not all of them.
void add_notice_of_stiff_parts(const AMF::Rest_shape& shape, std::vector<std::string>& notices)
{
  std::size_t of_triangles = 0;
  for (std::size_t v = 0; v < shape.number_of_vertices(); ++v) of_triangles += shape.is_isolated(v) ? 0 : 1;
  const std::size_t measured = shape.measured_vertices().size();
  if (measured < of_triangles)
    notices.push_back("parts of " + std::to_string(of_triangles - measured) + " vertices keep their shape; the size of " +
                      "the body, which lengths are fractions of, is that of the other " + std::to_string(measured));
}

} // namespace

Animation::Animation(const Reading_options& options, const AMF::IO::Memory_chooser& choose_memory,
                     AMF::Any_visitor visitor)
{
  const Model_format format = model_format(options.inputs);
  check_options(options, format);
  File_data data = format == Model_format::NONE
                       ? AMF::IO::read_animation<FT>(options.inputs, mesh_reading_options(options), choose_memory)
                       : read_model_file(options, format, choose_memory);
  m_is_sampled = format == Model_format::GLTF || format == Model_format::ASSIMP;
  take(options, data);
  if (!m_is_sampled) { // what is made of keys has no noise
    const Denoised done = denoise(
        options, m_mesh, [&] { return given_shape(options, data, m_is_sampled); }, m_sequence, m_notices, visitor);
    m_noise = done.noise;
    if (done.frame && options.rest.kind != Rest::FILE) // the mesh goes with its frame
      for (std::size_t v = 0; v < data.mesh.points.size(); ++v) {
        const AMF::Rest_shape::Point p = m_sequence->trajectories().point(v, *done.frame);
        data.mesh.points[v] = {{p[0], p[1], p[2]}};
      }
  }
  m_rest = take_rest(options, data, m_is_sampled, *m_sequence, m_notices, visitor);
  add_notice_of_stiff_parts(m_sequence->rest_shape(), m_notices);
  m_origins = std::move(data.origins);
}

Animation::Animation(const Reading_options& options, File_data data, const Rest_points& rest, AMF::Any_visitor visitor)
{
  AMF::IO::check_frames(options.skip_bad_frames, data);
  AMF::IO::weld_part(mesh_reading_options(options), data);
  take(options, data);
  Rest_points points;
  for (std::size_t v = 0; !rest.empty() && v < m_sequence->number_of_vertices(); ++v)
    points.push_back(rest[data.origins.empty() ? v : data.origins.file_vertices[data.origins.first[v]]]);
  const Denoised done = denoise(options, m_mesh, [&] { return points; }, m_sequence, m_notices, visitor);
  m_noise = done.noise;
  if (done.frame) points = m_sequence->trajectories().frame(*done.frame).points(); // the shape goes with its frame
  if (rest.empty()) {
    m_rest = take_rest(options, data, false, *m_sequence, m_notices, visitor);
  } else {
    m_rest = take_points(points, {"given", "the given rest shape", "", options.rest.rescale, 1}, *m_sequence);
  }
  add_notice_of_stiff_parts(m_sequence->rest_shape(), m_notices);
  m_origins = std::move(data.origins);
}

// All but the rest shape and the origins.
void Animation::take(const Reading_options& options, File_data& data)
{
  m_frames_read = data.frames;
  m_files = data.sources;
  m_files.insert(m_files.end(), data.linked_files.begin(), data.linked_files.end());
  if (!options.rest.file.empty()) m_files.push_back(options.rest.file);
  if (options.frame_range) keep_frames(*options.frame_range, data);
  if (options.is_cyclic) leave_out_repeated_frame(data);
  if (data.frames < 3)
    throw AMF::Input_error(data.sources.back() + ": the animation has " + std::to_string(data.frames) +
                           " frames; at least 3 are needed, since a feature has a frame before and one after it");
  m_frames_per_second = Programs::frames_per_second(options, data);
  if (!is_usable_rate(m_frames_per_second))
    throw AMF::Input_error(data.sources.back() + ": the times of the frames make " + number(m_frames_per_second) +
                           " frames in a second; --fps says how many there are");
  m_clip_name = Programs::clip_name(data);
  m_clips = data.clips;
  m_parts = AMF::IO::part_list(data);
  m_remarks = std::move(data.remarks);
  m_notices = std::move(data.notices);
  add_notice_of_slow_frames(options, m_frames_per_second, data, m_notices);
  m_mesh = AMF::IO::to_surface_mesh(data.mesh, data.sources.front());
  m_sequence.emplace(m_mesh, std::move(data.x), std::move(data.y), std::move(data.z), 1 / m_frames_per_second);
  check_size(*m_sequence, data.frame_name(0));
}

} // namespace Programs
