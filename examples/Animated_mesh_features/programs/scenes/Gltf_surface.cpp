// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/Gltf_surface.h"

#include "rendering/Palette.h"
#include "scenes/colour_scales.h"
#include "scenes/for_each_frame.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

typedef nlohmann::ordered_json Json;

namespace Programs {

namespace {

std::vector<float> difference(std::vector<float> values, const std::vector<float>& base)
{
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= base[i];
  return values;
}

} // namespace

Gltf_surface::Gltf_surface(const Shown_scene& scene, Gltf_buffer& buffer)
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

Json Gltf_surface::mesh() const
{
  Json targets = Json::array(), names = Json::array(); // Blender calls its shape keys by the names
  for (std::size_t f = 0; f < m_targets.size(); ++f) {
    targets.push_back(json_of(m_targets[f]));
    names.push_back("frame " + std::to_string(f));
  }
  std::vector<int> weights(m_targets.size(), 0);
  weights[0] = 1;
  const Json primitive = {
      {"attributes", json_of(m_base)}, {"indices", m_corners}, {"material", 0}, {"targets", std::move(targets)}};
  return {{"name", "surface"},
          {"primitives", Json::array({primitive})},
          {"weights", weights},
          {"extras", {{"targetNames", std::move(names)}}}};
}

Json Gltf_surface::material() const
{
  const Rendering::Colour c = has_colours() ? Rendering::Colour(1, 1, 1) : colour(0);
  return {{"name", "surface"},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {c[0], c[1], c[2], 1}}, {"metallicFactor", 0}, {"roughnessFactor", 0.8}}},
          {"doubleSided", true}}; // it may have a border, or be inside out
}

void Gltf_surface::write_targets(std::ostream& os) const
{
  for_each_frame(m_scene, [&](const Scene_frame& frame) {
    std::string bytes;
    append_little_endian(bytes, difference(frame.xyz, m_positions));
    append_little_endian(bytes, difference(vertex_normals(frame.xyz, m_triangles), m_normals));
    if (has_colours()) append_colours(bytes, frame.fields.front());
    os.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}

Rendering::Colour Gltf_surface::colour(double value) const
{
  return Rendering::field_colours()(m_top > 0 ? value / m_top : 0);
}

// Frame 0 and the colours; the bounds of the differences of all frames from frame 0.
std::vector<Gltf_buffer::Bounds> Gltf_surface::read_frames()
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
    bounds.push_back(Gltf_buffer::bounds(difference(frame.xyz, m_positions), 3));
  });
  for (float value : most) {
    for (float x : colour(value)) m_colours.push_back(std::uint8_t(std::lround(255 * x)));
    m_colours.push_back(255);
  }
  return bounds;
}

void Gltf_surface::add_base(Gltf_buffer& buffer)
{
  buffer.begin_view(Gltf_buffer::VERTICES, 12);
  m_base.position = buffer.add_with_bounds(m_positions, 3);
  m_base.normal = buffer.add(m_normals, 3);
  if (!has_colours()) return;
  buffer.begin_view(Gltf_buffer::VERTICES);
  m_base.colour = buffer.add(m_colours, 4);
}

void Gltf_surface::reserve_target(const Gltf_buffer::Bounds& bounds, Gltf_buffer& buffer)
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

void Gltf_surface::append_colours(std::string& bytes, const std::vector<float>& values) const
{
  std::vector<std::int8_t> differences(4 * values.size(), 0); // opacity does not change
  for (std::size_t v = 0; v < values.size(); ++v) {
    const Rendering::Colour now = colour(values[v]);
    for (std::size_t c = 0; c < 3; ++c)
      differences[4 * v + c] = std::int8_t(std::lround(127 * (now[c] - m_colours[4 * v + c] / 255.)));
  }
  append_little_endian(bytes, differences);
}

Json Gltf_surface::json_of(const Attributes& a) const
{
  Json json = {{"POSITION", a.position}, {"NORMAL", a.normal}};
  if (has_colours()) json["COLOR_0"] = a.colour;
  return json;
}

} // namespace Programs
