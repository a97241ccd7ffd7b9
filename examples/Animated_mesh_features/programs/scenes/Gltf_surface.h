// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_GLTF_SURFACE_H
#define PROGRAMS_SCENES_GLTF_SURFACE_H

#include "rendering/Colour.h"
#include "scenes/Gltf_buffer.h"
#include "scenes/Shown_scene.h"
#include "scenes/surface_shapes.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace Programs {

// The surface of a scene as glTF has it: one mesh with a morph target for each frame, which holds the differences from
// frame 0. Colours are those of the largest value of each vertex, which viewers show that do not animate colours; targets
// hold the differences from them.
class Gltf_surface
{
public:
  // Reserves the place of the targets: nothing can be added after them.
  Gltf_surface(const Shown_scene& scene, Gltf_buffer& buffer);

  bool has_colours() const { return !m_scene.fields.empty(); }
  double top() const { return m_top; } // the value that has the last colour

  nlohmann::ordered_json mesh() const;
  nlohmann::ordered_json material() const;

  // What was reserved.
  void write_targets(std::ostream& os) const;

private:
  struct Attributes // accessors
  {
    std::size_t position = 0, normal = 0, colour = 0;
  };

  Rendering::Colour colour(double value) const; // in linear light, as glTF has it
  std::vector<Gltf_buffer::Bounds> read_frames();
  void add_base(Gltf_buffer& buffer);
  void reserve_target(const Gltf_buffer::Bounds& bounds, Gltf_buffer& buffer);
  void append_colours(std::string& bytes, const std::vector<float>& values) const;
  nlohmann::ordered_json json_of(const Attributes& attributes) const;

  const Shown_scene& m_scene;
  const Triangles& m_triangles;
  double m_top = 0;
  std::size_t m_corners = 0; // accessor
  Attributes m_base;
  std::vector<Attributes> m_targets;
  std::vector<float> m_positions, m_normals; // in frame 0
  std::vector<std::uint8_t> m_colours;       // RGBA
};

} // namespace Programs

#endif // PROGRAMS_SCENES_GLTF_SURFACE_H
