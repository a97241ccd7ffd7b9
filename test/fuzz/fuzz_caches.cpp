// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Point caches. The first byte tells which format, P: PC2, M: MDD.

#include "fuzz_support.h"

#include <CGAL/Animated_mesh_features/IO/Point_cache_reader.h>
#include <CGAL/Animated_mesh_features/IO/write_point_cache.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
using fuzz::require;

namespace {

// Both ways of reading positions give the same ones, and all of them finite.
std::vector<float> positions(const std::string& path)
{
  Amf::IO::Point_cache_reader by_frame(path), by_vertex(path);
  const std::size_t n = by_frame.number_of_points(), frames = by_frame.number_of_frames();
  require(n > 0 && frames > 0, "a cache has points and frames");
  std::vector<float> xyz;
  by_frame.read_frames([&](std::size_t f, const float* frame) {
    require(f == xyz.size() / (3 * n), "frames come in their order");
    xyz.insert(xyz.end(), frame, frame + 3 * n);
  });
  Amf::Spatio_temporal_field<float> fields[3];
  by_vertex.read_fields<CGAL::Sequential_tag>(fields[0], fields[1], fields[2]);
  for (std::size_t f = 0; f < frames; ++f)
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t k = 0; k < 3; ++k) {
        const float x = xyz[3 * (f * n + v) + k];
        require(std::isfinite(x) && x == fields[k](v, f), "positions are finite, and the same by frame and by vertex");
      }
  return xyz;
}

// What was read, written again, is the file that was read.
std::string written(const std::string& path, bool is_pc2, const std::vector<float>& xyz)
{
  const Amf::IO::Point_cache_reader cache(path);
  const std::size_t n = cache.number_of_points();
  const auto frame = [&](std::size_t f, float* to) { std::copy_n(xyz.data() + 3 * n * f, 3 * n, to); };
  std::ostringstream out;
  if (is_pc2)
    Amf::IO::write_pc2(out, n, cache.number_of_frames(), frame, float(cache.start_frame()), float(cache.sample_rate()));
  else
    Amf::IO::write_mdd(out, n, std::vector<float>(cache.times().begin(), cache.times().end()), frame);
  return out.str();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0) return 0;
  const bool is_pc2 = data[0] % 2 == 0;
  const std::string& path = fuzz::files().write(is_pc2 ? ".pc2" : ".mdd", data + 1, size - 1);
  try {
    const std::string copy = written(path, is_pc2, positions(path));
    const std::size_t clock = is_pc2 ? 20 : 0, after_clock = is_pc2 ? 28 : 0; // numbers that may be NaN, of any sign
    const bool same = copy.size() == size - 1 && std::memcmp(copy.data(), data + 1, clock) == 0 &&
                      std::memcmp(copy.data() + after_clock, data + 1 + after_clock, size - 1 - after_clock) == 0;
    require(same, "the cache that was read and written is the same file");
  } catch (const Amf::Input_error&) {
  }
  return 0;
}
