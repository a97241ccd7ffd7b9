// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Animated models: glTF as text, or binary if it starts with its magic number.

#include "fuzz_support.h"

#include <CGAL/Animated_mesh_features/IO/read_gltf.h>
#include <CGAL/Animated_mesh_features/IO/sample_clip.h>
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace Amf = CGAL::Animated_mesh_features;
using fuzz::require;

namespace {

void check(const Amf::IO::Animation_file_data<float>& data)
{
  require(data.times.size() == data.frames, "each frame has its time");
  const auto surface = Amf::IO::to_surface_mesh(data.mesh, "model"); // vertices were welded so that it is one
  require(surface.is_valid(), "a surface is valid");
  require(data.x.number_of_rows() == data.mesh.points.size() && data.x.number_of_frames() == data.frames,
          "each vertex has its row of frames");
  for (std::size_t v = 0; v < data.x.number_of_rows(); ++v)
    for (std::size_t f = 0; f < data.frames; ++f)
      require(std::isfinite(data.x(v, f)) && std::isfinite(data.y(v, f)) && std::isfinite(data.z(v, f)),
              "positions are finite");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string& path = fuzz::files().write(".gltf", data, size);
  Amf::IO::Clip_sampling sampling;
  sampling.frames = 5;
  Amf::IO::Animation_file_data<float> animation;
  try {
    animation = Amf::IO::sample_clip<float, CGAL::Sequential_tag>(Amf::IO::read_gltf(path), sampling, path);
  } catch (const Amf::Input_error&) {
    return 0;
  }
  check(animation);
  return 0;
}
