// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_GLTF_FEATURES_H
#define PROGRAMS_SCENES_GLTF_FEATURES_H

#include "scenes/Gltf_buffer.h"
#include "scenes/Shown_scene.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace Programs {

// The features of a scene as glTF has them: a node for each, with a sphere. Its translation follows the surface, its scale
// is its radius in the frames in which it lives and 0 in others, which is how glTF hides a node.
class Gltf_features
{
public:
  Gltf_features(const Shown_scene& scene, Gltf_buffer& buffer);

  std::size_t number_of_features() const { return m_lives.size(); }

  // Each of the following appends to an array that has one element already: meshes and materials are numbered from 1.

  void append_nodes(nlohmann::ordered_json& nodes) const;
  void append_meshes(nlohmann::ordered_json& meshes) const;
  void append_materials(nlohmann::ordered_json& materials) const;
  void
  append_samplers(nlohmann::ordered_json& samplers) const; // two for each feature, of its translation and its scale

private:
  // Accessors of the samplers of a feature, and what it is like in frame 0.
  struct Life
  {
    std::size_t times, places, switch_times, sizes;
    std::array<float, 3> place;
    float size;
  };

  void choose_colours();
  void add_sphere(Gltf_buffer& buffer);
  void add_life(const Shown_feature& feature, Gltf_buffer& buffer);

  const Shown_scene& m_scene;
  std::size_t m_sphere = 0, m_sphere_corners = 0; // accessors
  std::vector<Life> m_lives;
  std::vector<std::size_t> m_steps, m_looks; // the colours that there are; which of them each feature has
};

} // namespace Programs

#endif // PROGRAMS_SCENES_GLTF_FEATURES_H
