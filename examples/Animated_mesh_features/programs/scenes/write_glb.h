// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_WRITE_GLB_H
#define PROGRAMS_SCENES_WRITE_GLB_H

#include "scenes/Shown_scene.h"

#include <ostream>

namespace Programs {

// Writes a scene as binary glTF 2.0 (GLB), for Blender and the many viewers of that format: no extension is needed.
//
// - Node `surface`: the surface. Morph target `f` is the difference of frame `f` from frame 0, of positions and normals, its
//   weight 1 at the time of frame `f` and 0 at those of other frames: one animation plays it at its own pace. If the scene
//   has a field, vertices have the colours of the first one, from clay to a deep blue-green at the value that 99 % do not
//   exceed; viewers that do not animate colours show, in all frames, the largest value over time.
// - Node `feature_1`, the strongest, and so on: a translucent sphere with the radius of the feature, which follows the
//   surface in the frames in which it lives (see lives_in_frame()) and has scale 0 in others; its colour goes from red for
//   the smallest tau of all features to blue for the largest. Its `extras` are `rank`, `vertex`, `frame`, `time`, `sigma`,
//   `tau`, `radius`, `amplitude`, `fit`, `strength`, `place`, `parent` (null without one), and `at_scale_limit`.
//
// Times are in seconds from the first frame, lengths in the unit of the animation.
//
// Size: 24 bytes for each vertex in each frame, 4 more with a field. Memory: a few frames.
//
// To a binary stream; its errors are left in its state, `Output_file` reports them.
// throws what check_scene() does if the scene does not fit together; Output_error if the file would exceed the 4 GiB that
// the format allows, or a number single precision.
void write_glb(std::ostream& os, const Shown_scene& scene);

} // namespace Programs

#endif // PROGRAMS_SCENES_WRITE_GLB_H
