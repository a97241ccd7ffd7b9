// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_FOR_EACH_FRAME_H
#define PROGRAMS_SCENES_FOR_EACH_FRAME_H

#include "scenes/Scene.h"
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/all_finite.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// One frame of a scene, in single precision, as files have it.
struct Scene_frame
{
  std::size_t index;
  std::vector<float> xyz;                 // vertex by vertex
  std::vector<std::vector<float>> fields; // in the order of the scene
};

// Calls `use` with the frames one after the other. In memory the frames of a vertex are neighbours: several are read at a
// time, so that each cache line is fetched once.
// throws Output_error if a number does not fit.
template <class Sequence, class Feature, class Use>
void for_each_frame(const Scene<Sequence, Feature>& scene, const Use& use)
{
  typedef typename Sequence::FT FT;
  constexpr std::size_t frames_at_once = 64 / sizeof(FT); // a cache line
  const auto& animation = scene.sequence.trajectories();
  const std::size_t n = animation.number_of_vertices(), frames = animation.number_of_frames();
  std::vector<Scene_frame> batch(frames_at_once);
  for (Scene_frame& frame : batch) {
    frame.xyz.resize(3 * n);
    frame.fields.assign(scene.fields.size(), std::vector<float>(n));
  }
  for (std::size_t begin = 0; begin < frames; begin += frames_at_once) {
    const std::size_t size = (std::min)(frames_at_once, frames - begin);
    const Spatio_temporal_field<FT>* const coordinates[] = {&animation.x, &animation.y, &animation.z};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t v = 0; v < n; ++v)
        for (std::size_t f = 0; f < size; ++f)
          batch[f].xyz[3 * v + c] = static_cast<float>((*coordinates[c])(v, begin + f));
    for (std::size_t i = 0; i < scene.fields.size(); ++i)
      for (std::size_t v = 0; v < n; ++v)
        for (std::size_t f = 0; f < size; ++f)
          batch[f].fields[i][v] = static_cast<float>((*scene.fields[i].values)(v, begin + f));
    for (std::size_t f = 0; f < size; ++f) {
      batch[f].index = begin + f;
      bool fits = Animated_mesh_features::internal::all_finite(batch[f].xyz.data(), 3 * n);
      for (const auto& field : batch[f].fields)
        fits = fits && Animated_mesh_features::internal::all_finite(field.data(), n);
      if (!fits)
        throw Output_error("frame " + std::to_string(begin + f) + " has numbers too large for single precision");
      use(static_cast<const Scene_frame&>(batch[f]));
    }
  }
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_SCENES_FOR_EACH_FRAME_H
