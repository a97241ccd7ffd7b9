// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Animation.h"

#include "reading/Model_file.h"

#include <CGAL/Animated_mesh_features/Animation/Canonical_shape.h>
#include <CGAL/Animated_mesh_features/IO/check_same_connectivity.h>
#include <CGAL/Animated_mesh_features/IO/read_mesh.h>
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;

namespace Detect_features {

namespace {

const double default_frames_per_second = 30;

void check_options(const Command_line& c, Model_format format)
{
  const bool is_model = format == Model_format::GLTF || format == Model_format::ASSIMP;
  if (c.clip_frames && !is_model)
    throw AMF::Option_error(
        "--frames goes with an animated model, of which frames are made; other inputs have their own");
  if (c.there_and_back && !is_model)
    throw AMF::Option_error("--there-and-back goes with an animated model, of which frames are made");
  if (c.clip_frames && *c.clip_frames < 3) throw AMF::Option_error("--frames: at least 3 are needed");
  if (!c.clip.empty() && format == Model_format::NONE)
    throw AMF::Option_error("--clip goes with a file that holds several animations: an animated model, or HDF5");
  if (!c.faces_dataset.empty() && format != Model_format::HDF5)
    throw AMF::Option_error("--faces goes with an HDF5 file");
}

AMF::IO::Mesh_reading_options reading_options(const Command_line& c)
{
  AMF::IO::Mesh_reading_options options;
  options.triangulate_faces = c.triangulate;
  return options;
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
                             " s behind the one before, others are " + std::to_string(usual) +
                             " s: the frames must be equidistant" + remedy);
  return (times.back() - times.front()) / double(steps.size());
}

} // namespace

Animation::Animation(const Command_line& command_line, const AMF::IO::Memory_chooser& choose_memory)
{
  const Model_format format = model_format(command_line.inputs);
  check_options(command_line, format);
  File_data data = format == Model_format::NONE
                       ? AMF::IO::read_animation<FT>(command_line.inputs, reading_options(command_line), choose_memory)
                       : read_model_file(command_line, format, choose_memory);
  m_is_sampled = format == Model_format::GLTF || format == Model_format::ASSIMP;
  if (data.frames < 3)
    throw AMF::Input_error(data.sources.back() + ": the animation has " + std::to_string(data.frames) +
                           " frames; at least 3 are needed, since a feature has a frame before and one behind it");
  set_frame_duration(command_line, data);
  take_notes(data);
  m_mesh = AMF::IO::to_surface_mesh(data.mesh, data.sources.front());
  m_sequence.emplace(m_mesh, std::move(data.x), std::move(data.y), std::move(data.z), 1 / m_frames_per_second);
  set_rest(command_line, data);
}

void Animation::take_notes(File_data& data)
{
  m_clips = data.clips;
  m_origins = std::move(data.origins);
  m_remarks = std::move(data.remarks);
  if (m_clips.empty()) return;
  m_clip_name = m_clips[data.clip];
  if (m_clip_name.empty() || std::count(m_clips.begin(), m_clips.end(), m_clip_name) > 1)
    m_clip_name = std::to_string(data.clip);
}

void Animation::set_frame_duration(const Command_line& command_line, const File_data& data)
{
  if (command_line.frames_per_second)
    m_frames_per_second = *command_line.frames_per_second;
  else if (!data.times.empty())
    m_frames_per_second = 1 / frame_duration(data.times, data.sources.back());
  else
    m_frames_per_second = default_frames_per_second;
}

void Animation::set_rest(const Command_line& command_line, const File_data& data)
{
  if (command_line.rest_frame) {
    if (*command_line.rest_frame >= data.frames)
      throw AMF::Option_error("--rest " + command_line.rest + ": there is no such frame; frames are 0 to " +
                              std::to_string(data.frames - 1));
    if (*command_line.rest_frame != 0) m_sequence->set_rest_frame(*command_line.rest_frame); // it is the first already
  } else if (command_line.rest_file.empty()) {
    AMF::set_canonical_rest_shape(*m_sequence);
  } else {
    const std::string& file = command_line.rest_file;
    const AMF::IO::Indexed_mesh rest = AMF::IO::read_mesh(file, reading_options(command_line));
    AMF::IO::check_same_connectivity(data.mesh, data.sources.front(), rest, file);
    std::vector<Sequence::Point_3> points;
    points.reserve(rest.points.size());
    for (const auto& p : rest.points) points.emplace_back(p[0], p[1], p[2]);
    const AMF::Rest_unit unit = command_line.rescale_rest ? AMF::Rest_unit::RESCALE : AMF::Rest_unit::CHECK;
    try {
      m_rest_factor = m_sequence->set_rest_shape(points, unit);
    } catch (const AMF::Input_error& e) {
      throw AMF::Input_error(file + ": " + e.what());
    }
  }
}

} // namespace Detect_features
