// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_EDGES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_EDGES_H

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

// The lengths of edges in one frame: an edge of two triangles is there twice.
struct Frame_edges
{
  double longest = 0, median = 0, mean = 0;
  std::array<std::size_t, 2> ends_of_longest{};
};

template <class FT>
Frame_edges frame_edges(const Animation_file_data<FT>& data, std::size_t f)
{
  Frame_edges result;
  std::vector<double> lengths;
  lengths.reserve(3 * data.mesh.triangles.size());
  for (const std::array<std::size_t, 3>& t : data.mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = t[i], w = t[(i + 1) % 3];
      lengths.push_back(distance(position(data, v, f), position(data, w, f)));
      result.mean += lengths.back();
      if (lengths.back() <= result.longest) continue;
      result.longest = lengths.back();
      result.ends_of_longest = {{v, w}};
    }
  result.mean /= double(lengths.size());
  const auto middle = lengths.begin() + std::ptrdiff_t(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  result.median = *middle;
  return result;
}

// Whether no triangle has an area: of a surface that is one, the first triangles tell.
template <class FT>
bool has_no_area(const Animation_file_data<FT>& data, std::size_t f)
{
  const double least_height = 1e-6; // over the longest edge: no surface consists of such needles
  for (const std::array<std::size_t, 3>& t : data.mesh.triangles) {
    const Position p = position(data, t[0], f), q = position(data, t[1], f), r = position(data, t[2], f);
    double u[3], w[3];
    const double longest = (std::max)({distance(p, q), distance(q, r), distance(r, p)});
    if (!(longest > 0)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = (q[i] - p[i]) / longest;
      w[i] = (r[i] - p[i]) / longest;
    }
    const double area = std::hypot(u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]);
    if (area > least_height) return false;
  }
  return true;
}

// The middle of all vertices in triangles, in which one that is far away has no part.
template <class FT>
Position middle_of_frame(const Animation_file_data<FT>& data, std::size_t f)
{
  Position middle{};
  std::vector<double> x;
  for (std::size_t i = 0; i < 3; ++i) {
    x.clear();
    for (const std::array<std::size_t, 3>& t : data.mesh.triangles)
      for (std::size_t v : t) x.push_back(position(data, v, f)[i]);
    const auto m = x.begin() + std::ptrdiff_t(x.size() / 2);
    std::nth_element(x.begin(), m, x.end());
    middle[i] = *m;
  }
  return middle;
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_EDGES_H
