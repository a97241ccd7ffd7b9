// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_GLTF_SURFACE_H
#define PROGRAMS_SCENES_GLTF_SURFACE_H

#include "scenes/Scene.h"
#include "scenes/Gltf_buffer.h"
#include "scenes/for_each_frame.h"
#include "scenes/colour_scales.h"
#include "rendering/Palette.h"
#include "scenes/surface_shapes.h"
#include <CGAL/Animated_mesh_features/IO/write_json.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// The surface of a scene as glTF has it: one mesh with a morph target for each frame, which holds the differences from
// frame 0. Colours are those of the largest value of each vertex, which viewers show that do not animate colours; targets
// hold the differences from them.
template <class Sequence, class Feature>
class Gltf_surface
{
  typedef Programs::Rendering::Colour Colour; // in linear light, as glTF has it

public:
  // Reserves the place of the targets: nothing can be added behind them.
  Gltf_surface(const Scene<Sequence, Feature>& scene, Gltf_buffer& buffer)
    : m_scene(scene)
    , m_triangles(scene.sequence.rest_shape().triangles())
  {
    if (has_colours()) m_top = top_of_scale(*scene.fields.front().values);
    std::vector<std::uint32_t> corners;
    for (const auto& t : m_triangles) corners.insert(corners.end(), t.begin(), t.end());
    buffer.begin_view(Gltf_buffer::TRIANGLES);
    m_corners = buffer.add(corners, 1);
    const std::vector<Gltf_buffer::Bounds> bounds = read_frames();
    add_base(buffer);
    for (const Gltf_buffer::Bounds& b : bounds) reserve_target(b, buffer);
  }

  bool has_colours() const { return !m_scene.fields.empty(); }
  double top() const { return m_top; } // the value that has the last colour

  void write_mesh(Json_output& out) const
  {
    out.raw("\n{\"name\":\"surface\",\"primitives\":[{\"attributes\":");
    write_attributes(out, m_base);
    out.raw(",").member("indices", m_corners).raw(",\"material\":0,\"targets\":[");
    const char* separator = "\n";
    for (const Attributes& target : m_targets) {
      out.raw(separator);
      write_attributes(out, target);
      separator = ",\n";
    }
    std::vector<std::string> names; // by which Blender calls its shape keys
    for (std::size_t f = 0; f < m_targets.size(); ++f) names.push_back("frame " + std::to_string(f));
    std::vector<int> weights(m_targets.size(), 0);
    weights[0] = 1;
    out.raw("]}],\n").member("weights", weights).raw(",\"extras\":{").member("targetNames", names).raw("}}");
  }

  void write_material(Json_output& out) const
  {
    const Colour c = has_colours() ? Colour(1, 1, 1) : colour(0);
    out.raw("\n{\"name\":\"surface\",\"pbrMetallicRoughness\":{");
    out.member("baseColorFactor", std::array<float, 4>{{c[0], c[1], c[2], 1}});
    // it may have a border, or be inside out
    out.raw(",\"metallicFactor\":0,\"roughnessFactor\":0.8},\"doubleSided\":true}");
  }

  // What was reserved.
  void write_targets(std::ostream& os) const
  {
    for_each_frame(m_scene, [&](const Scene_frame& frame) {
      std::string bytes;
      append_difference(bytes, frame.xyz, m_positions);
      append_difference(bytes, vertex_normals(frame.xyz, m_triangles), m_normals);
      if (has_colours()) append_colours(bytes, frame.fields.front());
      os.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
  }

private:
  struct Attributes // accessors
  {
    std::size_t position = 0, normal = 0, colour = 0;
  };

  Colour colour(double value) const
  {
    return Programs::Rendering::field_colours()(m_top > 0 ? value / m_top : 0);
  }

  // Frame 0 and the colours; the bounds of the differences of all frames from frame 0.
  std::vector<Gltf_buffer::Bounds> read_frames()
  {
    std::vector<Gltf_buffer::Bounds> bounds;
    std::vector<float> most; // of the field, for each vertex
    for_each_frame(m_scene, [&](const Scene_frame& frame) {
      if (frame.index == 0) {
        m_positions = frame.xyz;
        m_normals = vertex_normals(frame.xyz, m_triangles);
        if (has_colours()) most = frame.fields.front();
      }
      for (std::size_t v = 0; v < most.size(); ++v) most[v] = (std::max)(most[v], frame.fields.front()[v]);
      std::vector<float> difference(frame.xyz);
      for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= m_positions[i];
      bounds.push_back(Gltf_buffer::bounds(difference.data(), difference.size(), 3));
    });
    for (float value : most) {
      for (float x : colour(value)) m_colours.push_back(std::uint8_t(std::lround(255 * x)));
      m_colours.push_back(255);
    }
    return bounds;
  }

  void add_base(Gltf_buffer& buffer)
  {
    buffer.begin_view(Gltf_buffer::VERTICES, 12);
    m_base.position = buffer.add(m_positions, 3, true);
    m_base.normal = buffer.add(m_normals, 3);
    if (!has_colours()) return;
    buffer.begin_view(Gltf_buffer::VERTICES);
    m_base.colour = buffer.add(m_colours, 4);
  }

  void reserve_target(const Gltf_buffer::Bounds& bounds, Gltf_buffer& buffer)
  {
    const std::size_t n = m_positions.size() / 3;
    Attributes target;
    buffer.begin_view(Gltf_buffer::VERTICES, 12);
    target.position = buffer.reserve<float>(n, 3, bounds);
    target.normal = buffer.reserve<float>(n, 3);
    if (has_colours()) {
      buffer.begin_view(Gltf_buffer::VERTICES);
      target.colour = buffer.reserve<std::int8_t>(n, 4);
    }
    m_targets.push_back(target);
  }

  static void append_difference(std::string& bytes, std::vector<float> values, const std::vector<float>& base)
  {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= base[i];
    append_little_endian(bytes, values.data(), values.size());
  }

  void append_colours(std::string& bytes, const std::vector<float>& values) const
  {
    std::vector<std::int8_t> differences(4 * values.size(), 0); // opacity does not change
    for (std::size_t v = 0; v < values.size(); ++v) {
      const Colour now = colour(values[v]);
      for (std::size_t c = 0; c < 3; ++c)
        differences[4 * v + c] = std::int8_t(std::lround(127 * (now[c] - m_colours[4 * v + c] / 255.)));
    }
    append_little_endian(bytes, differences.data(), differences.size());
  }

  void write_attributes(Json_output& out, const Attributes& a) const
  {
    out.raw("{").member("POSITION", a.position).raw(",").member("NORMAL", a.normal);
    if (has_colours()) out.raw(",").member("COLOR_0", a.colour);
    out.raw("}");
  }

  const Scene<Sequence, Feature>& m_scene;
  const std::vector<Rest_shape::Triangle>& m_triangles;
  double m_top = 0;
  std::size_t m_corners = 0; // accessor
  Attributes m_base;
  std::vector<Attributes> m_targets;
  std::vector<float> m_positions, m_normals; // in frame 0
  std::vector<std::uint8_t> m_colours;       // RGBA
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_SCENES_GLTF_SURFACE_H
