// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_NOISE_OF_FRAMES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_NOISE_OF_FRAMES_H

#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/internal/frame_position.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// What is looked at of an animation to judge the lengths of its edges: up to 16 frames, up to 30,000 edges.
struct Edge_sample
{
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::size_t> frames;
};

template <class FT>
Edge_sample edge_sample(const Animation_file_data<FT>& data)
{
  const std::size_t most_edges = 30000, most_frames = 16;
  Edge_sample result;
  const std::size_t corners = 3 * data.mesh.triangles.size(), step = corners / most_edges + 1;
  for (std::size_t c = 0; c < corners; c += step) {
    const std::array<std::size_t, 3>& t = data.mesh.triangles[c / 3];
    result.edges.push_back({{t[c % 3], t[(c + 1) % 3]}});
  }
  const std::size_t n = (std::min)(most_frames, data.frames);
  for (std::size_t i = 0; i < n; ++i) result.frames.push_back(n > 1 ? i * (data.frames - 1) / (n - 1) : 0);
  return result;
}

inline double median(std::vector<double>& values)
{
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The standard deviation, in each coordinate, of noise that is independent in vertices and frames: 0 of less than three
// frames. The second difference in time of an edge's vector has in each coordinate 2 (1 + 4 + 1) times the variance of the
// noise, while neighbours move alike: what is left of the motion itself, on animations without noise, is .3 to 5 % of the
// edge, at most 11 % where a body leaps between two frames. The median length of a normal vector in space is 1.538 times
// the standard deviation of its coordinates.
template <class FT>
double noise_of_frames(const Animation_file_data<FT>& data, const Edge_sample& sample)
{
  if (data.frames < 3) return 0;
  std::vector<double> lengths;
  for (const std::size_t at : sample.frames) {
    const std::size_t f = (std::min)((std::max)(at, std::size_t(1)), data.frames - 2);
    for (const auto& edge : sample.edges) {
      Position second = {{0, 0, 0}};
      for (const std::size_t end : {0, 1}) {
        const Position before = position(data, edge[end], f - 1), now = position(data, edge[end], f),
                       after = position(data, edge[end], f + 1);
        for (std::size_t k = 0; k < 3; ++k) second[k] += (end == 0 ? 1 : -1) * (before[k] - 2 * now[k] + after[k]);
      }
      const double length = std::hypot(second[0], second[1], second[2]);
      if (std::isfinite(length)) lengths.push_back(length);
    }
  }
  return median(lengths) / (1.538 * std::sqrt(12.));
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_NOISE_OF_FRAMES_H
