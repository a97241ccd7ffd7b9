// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_GLTF_SCENE_H
#define PROGRAMS_SCENES_GLTF_SCENE_H

#include "scenes/Gltf_buffer.h"
#include "scenes/Gltf_features.h"
#include "scenes/Gltf_surface.h"
#include "scenes/Shown_scene.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <ostream>
#include <string>

namespace Programs {

// A scene as glTF has it: the JSON, and the binary part after it. The weight of a frame's morph target is 1 at the time of
// the frame and 0 at those of others, so that positions are linear between frames.
class Gltf_scene
{
public:
  explicit Gltf_scene(const Shown_scene& scene);

  // of the binary part, in bytes
  std::size_t size() const { return m_buffer.size(); }

  std::string json() const;
  void write_binary(std::ostream& os) const;

private:
  struct Playing // accessors
  {
    std::size_t times, weights;
  };

  Playing add_playing();
  nlohmann::ordered_json scene() const;
  nlohmann::ordered_json animation() const;

  const Shown_scene& m_scene;
  Gltf_buffer m_buffer; // before those that fill it, in the order of its content
  Gltf_features m_features;
  Playing m_playing;
  Gltf_surface m_surface;
};

} // namespace Programs

#endif // PROGRAMS_SCENES_GLTF_SCENE_H
