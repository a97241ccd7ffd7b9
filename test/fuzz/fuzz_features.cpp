// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of features, and those that they are compared with: paintings, events of rigs.

#include <CGAL/Animated_mesh_features/IO/read_json.h>
#include <CGAL/Animated_mesh_features/IO/read_painting.h>
#include <CGAL/Animated_mesh_features/IO/read_rig_events.h>
#include <CGAL/Animated_mesh_features/IO/write_json.h>
#include <CGAL/Animated_mesh_features/IO/write_rig_events.h>

#include "fuzz_support.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

namespace Amf = CGAL::Animated_mesh_features;
using fuzz::require;

namespace {

Amf::IO::Feature_file_data read(const std::string& text)
{
  std::istringstream in(text);
  return Amf::IO::read_json(in, "features.json");
}

std::string written(const Amf::IO::Feature_file_data& data)
{
  std::ostringstream out;
  Amf::IO::write_json(out, data);
  return out.str();
}

void check(const Amf::IO::Feature_file_data& data)
{
  for (const Amf::Feature_point& f : data.features) {
    require(f.vertex_index < data.description.vertices && f.frame < data.description.frames, "there is such a vertex");
    bool finite = std::isfinite(f.time) && std::isfinite(f.refined_frame) && std::isfinite(f.sigma) &&
                  std::isfinite(f.tau) && std::isfinite(f.response);
    for (std::size_t k = 0; k < 3; ++k) {
      finite = finite && std::isfinite(f.position[k]) && std::isfinite(f.rest_position[k]) &&
               std::isfinite(f.barycentric_coordinates[k]);
      require(f.triangle[k] < data.description.vertices, "the triangle's corners are vertices");
    }
    require(finite, "numbers of features are finite");
  }
}

void check_features(const std::string& file)
{
  const Amf::IO::Feature_file_data data = read(file);
  check(data);
  // of what it has written, reading and writing make the same bytes
  const std::string text = written(data);
  Amf::IO::Feature_file_data again;
  try {
    again = read(text);
  } catch (const Amf::Input_error& e) {
    require(false, e.what());
  }
  require(written(again) == text, "what is written, read and written again is the same");
}

void check_painting(const std::string& file)
{
  std::istringstream in(file);
  const Amf::IO::Painting_file_data data = Amf::IO::read_painting(in, "painting.json");
  require(std::isfinite(data.frame_duration) && data.frame_duration > 0, "the time between two frames is positive");
  for (const auto& stroke : data.strokes) {
    require(stroke.first_frame <= stroke.last_frame && stroke.last_frame < data.frames, "there are such frames");
    for (std::size_t v : stroke.vertices) require(v < data.vertices, "there is such a vertex");
  }
}

void check_rig(const std::string& file)
{
  std::istringstream in(file);
  const Amf::IO::Rig_file_data data = Amf::IO::read_rig_events(in, "rig.json");
  for (const auto& joint : data.joints) {
    for (std::size_t v : joint.region) require(v < data.vertices, "there is such a vertex");
    for (const auto& m : joint.maxima)
      require(std::isfinite(m.time) && m.time >= 0 && std::isfinite(m.angle) && m.angle >= 0 &&
                  std::isfinite(m.prominence) && m.prominence >= 0,
              "numbers of events are finite and not negative");
  }
  std::ostringstream first, second;
  Amf::IO::write_rig_events(first, data);
  std::istringstream back(first.str());
  try {
    Amf::IO::write_rig_events(second, Amf::IO::read_rig_events(back, "back.json"));
  } catch (const Amf::Input_error& e) {
    require(false, e.what());
  }
  require(first.str() == second.str(), "what is written, read and written again is the same");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  const std::string file(reinterpret_cast<const char*>(bytes), size);
  for (const auto check_file : {check_features, check_painting, check_rig}) {
    try {
      check_file(file);
    } catch (const Amf::Input_error&) {}
  }
  return 0;
}
