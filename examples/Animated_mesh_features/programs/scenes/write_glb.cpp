// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/write_glb.h"

#include "scenes/Gltf_scene.h"
#include "scenes/append_little_endian.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace Programs {

namespace {

void check_size(double bytes)
{
  const double largest = double((std::numeric_limits<std::uint32_t>::max)());
  if (bytes > largest)
    throw CGAL::Animated_mesh_features::Output_error(
        "a GLB file of this animation would have " + std::to_string(std::uint64_t(bytes)) +
        " bytes; the format allows " + std::to_string(std::uint64_t(largest)));
}

void put(std::ostream& os, std::size_t number)
{
  std::string bytes;
  append_little_endian(bytes, std::vector<std::uint32_t>{static_cast<std::uint32_t>(number)});
  os << bytes;
}

} // namespace

void write_glb(std::ostream& os, const Shown_scene& scene)
{
  check_scene(scene);
  // before anything is made that is as large
  const double frames = double(scene.sequence.number_of_frames());
  check_size(frames * (24 * double(scene.sequence.number_of_vertices()) + 4 * frames));

  const Gltf_scene gltf(scene);
  std::string json = gltf.json();
  json.append((4 - json.size() % 4) % 4, ' ');
  const std::size_t headers = 12 + 8 + 8;
  check_size(double(headers) + double(json.size()) + double(gltf.size()));
  os << "glTF";
  put(os, 2);
  put(os, headers + json.size() + gltf.size());
  put(os, json.size());
  os << "JSON" << json;
  put(os, gltf.size());
  os.write("BIN\0", 4);
  gltf.write_binary(os);
}

} // namespace Programs
