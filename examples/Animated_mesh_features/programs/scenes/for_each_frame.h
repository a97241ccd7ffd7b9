// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_FOR_EACH_FRAME_H
#define PROGRAMS_SCENES_FOR_EACH_FRAME_H

#include "scenes/Shown_scene.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace Programs {

// One frame of a scene, in single precision, as files have it.
struct Scene_frame
{
  std::size_t index;
  std::vector<float> xyz;                 // vertex by vertex
  std::vector<std::vector<float>> fields; // in the order of the scene
};

// Calls `use` with the frames one after the other; takes the memory of eight of them.
// throws Output_error if a number does not fit.
void for_each_frame(const Shown_scene& scene, const std::function<void(const Scene_frame&)>& use);

} // namespace Programs

#endif // PROGRAMS_SCENES_FOR_EACH_FRAME_H
