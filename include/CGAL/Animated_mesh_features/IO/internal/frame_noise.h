// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_NOISE_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_NOISE_H

#include <CGAL/Animated_mesh_features/Animation/position_noise.h>
#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/internal/frame_position.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Up to 30,000 edges: of a larger mesh every second, third... side of a triangle.
template <class FT>
std::vector<std::array<std::size_t, 2>> some_edges(const Animation_file_data<FT>& data)
{
  const std::size_t most_edges = 30000;
  std::vector<std::array<std::size_t, 2>> edges;
  const std::size_t corners = 3 * data.mesh.triangles.size(), step = corners / most_edges + 1;
  for (std::size_t c = 0; c < corners; c += step) {
    const std::array<std::size_t, 3>& t = data.mesh.triangles[c / 3];
    edges.push_back({{t[c % 3], t[(c + 1) % 3]}});
  }
  return edges;
}

// position_noise() of what was read.
template <class FT>
double frame_noise(const Animation_file_data<FT>& data)
{
  return position_noise(some_edges(data), data.frames,
                        [&](std::size_t v, std::size_t f) { return position(data, v, f); });
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_NOISE_H
