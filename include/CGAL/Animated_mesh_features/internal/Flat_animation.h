// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_FLAT_ANIMATION_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_FLAT_ANIMATION_H

#include <CGAL/Animated_mesh_features/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/exceptions.h>
#include <CGAL/Animated_mesh_features/internal/all_finite.h>
#include <CGAL/Animated_mesh_features/internal/parallel_for.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// An animation as the kernels see it: no descriptors, no property maps, the coordinates of a vertex contiguous over
// the frames.
template <class FT>
struct Flat_animation
{
  Rest_shape rest;
  Spatio_temporal_field<FT> x, y, z; // N x F
  double frame_duration = 0;         // seconds

  std::size_t number_of_vertices() const { return x.number_of_rows(); }
  std::size_t number_of_frames() const { return x.number_of_frames(); }

  Rest_shape::Point point(std::size_t v, std::size_t f) const
  {
    return Rest_shape::Point(x(v, f), y(v, f), z(v, f));
  }

  void resize(std::size_t n, std::size_t f)
  {
    x = Spatio_temporal_field<FT>(n, f);
    y = Spatio_temporal_field<FT>(n, f);
    z = Spatio_temporal_field<FT>(n, f);
  }

  std::vector<Rest_shape::Point> frame(std::size_t f) const
  {
    std::vector<Rest_shape::Point> points(number_of_vertices());
    for (std::size_t v = 0; v < points.size(); ++v) points[v] = point(v, f);
    return points;
  }
};

// The first vertex, and its first frame, whose position is not finite; `false` if there is none.
template <class FT>
bool find_not_finite(const Flat_animation<FT>& animation, std::size_t& vertex, std::size_t& frame)
{
  // on several threads: it takes as long as the memory needs to pass by
  constexpr std::size_t block_size = 1024;
  const std::size_t n = animation.number_of_vertices(), frames = animation.number_of_frames();
  const std::size_t blocks = (n + block_size - 1) / block_size;
  std::vector<char> is_good(blocks, 0);
  parallel_for<CGAL::Parallel_if_available_tag>(0, blocks, [&](std::size_t b) {
    bool good = true;
    // one coordinate after the other, as memory likes it
    for (const Spatio_temporal_field<FT>* c : {&animation.x, &animation.y, &animation.z})
      for (std::size_t v = b * block_size; v < (std::min)(n, (b + 1) * block_size); ++v)
        good = good && all_finite(c->row(v), frames);
    is_good[b] = good;
  });
  const auto bad = std::find(is_good.begin(), is_good.end(), 0);
  if (bad == is_good.end()) return false;
  for (vertex = std::size_t(bad - is_good.begin()) * block_size; vertex < n; ++vertex)
    for (frame = 0; frame < frames; ++frame)
      if (!animation.point(vertex, frame).allFinite()) return true;
  return false;
}

inline void check_clock(std::size_t number_of_frames, double frame_duration)
{
  // a feature has a frame before and a frame behind it
  if (number_of_frames < 3)
    throw Input_error("the animation has " + std::to_string(number_of_frames) +
                      " frame(s); at least 3 are needed, since a feature has a frame before and one behind it");
  if (!(frame_duration > 0) || !std::isfinite(frame_duration))
    throw Input_error("the time between frames is " + std::to_string(frame_duration) + " s; it must be positive");
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_FLAT_ANIMATION_H
