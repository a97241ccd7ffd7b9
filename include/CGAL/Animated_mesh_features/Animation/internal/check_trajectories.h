// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_CHECK_TRAJECTORIES_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_CHECK_TRAJECTORIES_H

#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Numerics/all_finite.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The first vertex, and its first frame, whose position is not finite; `false` if there is none.
template <class FT>
bool find_not_finite(const Vertex_trajectories<FT>& trajectories, std::size_t& vertex, std::size_t& frame)
{
  // on several threads: it takes as long as the memory needs to pass by
  constexpr std::size_t block_size = 1024;
  const std::size_t n = trajectories.number_of_vertices(), frames = trajectories.number_of_frames();
  const std::size_t blocks = (n + block_size - 1) / block_size;
  std::vector<char> is_good(blocks, 0);
  parallel_for<CGAL::Parallel_if_available_tag>(0, blocks, [&](std::size_t b) {
    bool good = true;
    // one coordinate after the other, as memory likes it
    for (const Spatio_temporal_field<FT>* c : {&trajectories.x, &trajectories.y, &trajectories.z})
      for (std::size_t v = b * block_size; v < (std::min)(n, (b + 1) * block_size); ++v)
        good = good && all_finite(c->row(v), frames);
    is_good[b] = good;
  });
  const auto bad = std::find(is_good.begin(), is_good.end(), 0);
  if (bad == is_good.end()) return false;
  for (vertex = std::size_t(bad - is_good.begin()) * block_size; vertex < n; ++vertex)
    for (frame = 0; frame < frames; ++frame)
      if (!trajectories.point(vertex, frame).allFinite()) return true;
  return false;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_CHECK_TRAJECTORIES_H
