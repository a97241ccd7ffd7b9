// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_BRIDGE_FRAMES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_BRIDGE_FRAMES_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// A frame that is left out, and the good ones next to it; at an end both are the same.
struct Bridged_frame
{
  std::size_t frame, before, after;
};

// For each frame that is not good. At least one must be.
inline std::vector<Bridged_frame> bridged_frames(const std::vector<char>& is_good)
{
  std::vector<Bridged_frame> bridged;
  const std::size_t n = is_good.size();
  std::size_t before = n, after = 0;
  for (std::size_t f = 0; f < n; ++f) {
    if (is_good[f]) {
      before = f;
      continue;
    }
    if (after <= f)
      for (after = f; after < n && !is_good[after];) ++after;
    bridged.push_back({f, before < n ? before : after, after < n ? after : before});
  }
  return bridged;
}

// Puts in their place what lies between the good ones, linearly in time, or the nearest good one at an end: numbers and
// times of frames stay.
template <class ConcurrencyTag, class FT>
void bridge_frames(const std::vector<Bridged_frame>& bridged, Animation_file_data<FT>& data)
{
  for (Spatio_temporal_field<FT>* c : {&data.x, &data.y, &data.z})
    parallel_for<ConcurrencyTag>(0, c->number_of_rows(), [&](std::size_t v) {
      FT* x = c->row(v);
      for (const Bridged_frame& b : bridged) {
        const double share = b.after == b.before ? 0. : double(b.frame - b.before) / double(b.after - b.before);
        x[b.frame] = FT((1 - share) * double(x[b.before]) + share * double(x[b.after]));
      }
    });
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_BRIDGE_FRAMES_H
