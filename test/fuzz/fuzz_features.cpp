// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of features.

#include <CGAL/Animated_mesh_features/IO/read_json.h>
#include <CGAL/Animated_mesh_features/IO/write_json.h>

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

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  try {
    const Amf::IO::Feature_file_data data = read(std::string(reinterpret_cast<const char*>(bytes), size));
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
  } catch (const Amf::Input_error&) {
  }
  return 0;
}
