// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_EXTENTS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_EXTENTS_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// What a frame's coordinates say at a glance; of vertices in triangles only.
struct Frame_extent
{
  double diagonal = 0;             // of the bounding box
  double magnitude = 0;            // of the largest coordinate
  bool is_single_precision = true; // every coordinate is a number in single precision

  // Whether there is more than the rounding of a point.
  bool is_extended() const
  {
    const double rounding = is_single_precision ? double((std::numeric_limits<float>::epsilon)())
                                                : (std::numeric_limits<double>::epsilon)();
    return diagonal > 4 * rounding * magnitude;
  }
};

inline std::vector<std::size_t> vertices_in_triangles(const Indexed_mesh& mesh, std::size_t number_of_vertices)
{
  std::vector<char> is_used(number_of_vertices, 0);
  for (const std::array<std::size_t, 3>& t : mesh.triangles)
    for (std::size_t v : t) is_used[v] = 1;
  std::vector<std::size_t> used;
  for (std::size_t v = 0; v < number_of_vertices; ++v)
    if (is_used[v]) used.push_back(v);
  return used;
}

// The extents of some successive frames, not more than `most`: the rows of vertices pass by once, as memory likes it.
template <std::size_t most, class FT>
void frame_extents(const Animation_file_data<FT>& data, const std::vector<std::size_t>& vertices, std::size_t first,
                   std::size_t n, Frame_extent* extents)
{
  const double infinity = (std::numeric_limits<double>::infinity)();
  for (const Spatio_temporal_field<FT>* c : {&data.x, &data.y, &data.z}) {
    std::array<double, most> low, high;
    low.fill(infinity);
    high.fill(-infinity);
    for (std::size_t v : vertices) {
      const FT* x = c->row(v) + first;
      for (std::size_t f = 0; f < n; ++f) {
        low[f] = (std::min)(low[f], double(x[f]));
        high[f] = (std::max)(high[f], double(x[f]));
        extents[f].is_single_precision &= double(float(x[f])) == double(x[f]);
      }
    }
    for (std::size_t f = 0; f < n && low[f] <= high[f]; ++f) {
      extents[f].magnitude = (std::max)(extents[f].magnitude, (std::max)(-low[f], high[f]));
      extents[f].diagonal = std::hypot(extents[f].diagonal, high[f] - low[f]);
    }
  }
}

// The extents of all frames, in `O(N F)` time.
template <class ConcurrencyTag, class FT>
std::vector<Frame_extent> frame_extents(const Animation_file_data<FT>& data)
{
  constexpr std::size_t frames_at_once = 64;
  const std::vector<std::size_t> vertices = vertices_in_triangles(data.mesh, data.x.number_of_rows());
  std::vector<Frame_extent> extents(data.frames);
  const std::size_t blocks = (data.frames + frames_at_once - 1) / frames_at_once;
  parallel_for<ConcurrencyTag>(0, blocks, [&](std::size_t b) {
    const std::size_t first = b * frames_at_once, n = (std::min)(frames_at_once, data.frames - first);
    frame_extents<frames_at_once>(data, vertices, first, n, extents.data() + first);
  });
  return extents;
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_EXTENTS_H
