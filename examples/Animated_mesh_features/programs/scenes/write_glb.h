// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_WRITE_GLB_H
#define PROGRAMS_SCENES_WRITE_GLB_H

#include "scenes/Scene.h"
#include "scenes/Gltf_buffer.h"
#include "scenes/Gltf_scene.h"
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes a scene as binary glTF 2.0 (GLB), for Blender and the many viewers of that format: no extension is needed.

- Node `surface`: the surface. Morph target `f` is the difference of frame `f` from frame 0, of positions and normals, its
  weight 1 at the time of frame `f` and 0 at those of other frames: one animation plays it at its own pace. If the scene
  has a field, vertices have the colours of the first one, from clay to a deep blue-green at the value that 99 % do not
  exceed; viewers that do not animate colours show, in all frames, the largest value over time.
- Node `feature_0`, the strongest, and so on: a translucent sphere with the radius of the feature, which follows the
  surface in the frames in which it lives (see `lives_in_frame()`) and has scale 0 in others; its colour goes from red for
  the smallest \f$\tau\f$ of all features to blue for the largest. Its `extras` are `rank`, `vertex`, `frame`, `time`,
  `sigma`, `tau`, `radius`, `strength`, and `at_scale_limit`.

Times are in seconds from the first frame, lengths in the unit of the animation.

Size: 24 bytes for each vertex in each frame, 4 more with a field. Memory: a few frames.

\param os a binary stream; errors are left in its state, `Output_file` reports them.
\param scene see `check_scene()` for what is thrown if it does not fit together.

\throw Output_error if the file would exceed the 4 GiB that the format allows, or a number single precision.
*/
template <class Sequence, class Feature>
void write_glb(std::ostream& os, const Scene<Sequence, Feature>& scene)
{
  check_scene(scene);
  const double largest = double((std::numeric_limits<std::uint32_t>::max)());
  const auto check_size = [&](double bytes) {
    if (bytes > largest)
      throw Output_error("a GLB file of this animation would have " + std::to_string(std::uint64_t(bytes)) +
                         " bytes; the format allows " + std::to_string(std::uint64_t(largest)));
  };
  // before anything is made that is as large
  const double frames = double(scene.sequence.number_of_frames());
  check_size(frames * (24 * double(scene.sequence.number_of_vertices()) + 4 * frames));

  const internal::Gltf_scene<Sequence, Feature> gltf(scene);
  std::string json = gltf.json();
  json.append((4 - json.size() % 4) % 4, ' ');
  const std::size_t headers = 12 + 8 + 8;
  check_size(double(headers) + double(json.size()) + double(gltf.size()));
  const auto put = [&](std::size_t number) {
    std::string bytes;
    const std::uint32_t u = static_cast<std::uint32_t>(number);
    internal::append_little_endian(bytes, &u, 1);
    os << bytes;
  };
  os << "glTF";
  put(2);
  put(headers + json.size() + gltf.size());
  put(json.size());
  os << "JSON" << json;
  put(gltf.size());
  os.write("BIN\0", 4);
  gltf.write_binary(os);
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_SCENES_WRITE_GLB_H
