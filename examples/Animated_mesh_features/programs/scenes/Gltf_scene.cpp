// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/Gltf_scene.h"

#include <nlohmann/json.hpp>

#include <numeric>
#include <vector>

typedef nlohmann::ordered_json Json;

namespace Programs {

Gltf_scene::Gltf_scene(const Shown_scene& scene)
  : m_scene(scene)
  , m_features(scene, m_buffer)
  , m_playing(add_playing())
  , m_surface(scene, m_buffer)
{}

std::string Gltf_scene::json() const
{
  Json gltf = {{"asset", {{"version", "2.0"}, {"generator", "Animated_mesh_features for CGAL"}}},
               {"scene", 0},
               {"scenes", Json::array({scene()})},
               {"nodes", Json::array({{{"name", "surface"}, {"mesh", 0}}})},
               {"meshes", Json::array({m_surface.mesh()})},
               {"materials", Json::array({m_surface.material()})},
               {"animations", Json::array({animation()})}};
  m_features.append_nodes(gltf["nodes"]);
  m_features.append_meshes(gltf["meshes"]);
  m_features.append_materials(gltf["materials"]);
  m_buffer.append_to(gltf);
  return gltf.dump(-1, ' ', false, Json::error_handler_t::replace); // the title may be any bytes
}

void Gltf_scene::write_binary(std::ostream& os) const
{
  os.write(m_buffer.data().data(), static_cast<std::streamsize>(m_buffer.data().size()));
  m_surface.write_targets(os);
}

Gltf_scene::Playing Gltf_scene::add_playing()
{
  const std::size_t frames = m_scene.sequence.number_of_frames();
  std::vector<float> times, weights(frames * frames, 0);
  for (std::size_t f = 0; f < frames; ++f) {
    times.push_back(static_cast<float>(double(f) * m_scene.sequence.frame_duration()));
    weights[f * frames + f] = 1;
  }
  m_buffer.begin_view(Gltf_buffer::ANIMATION);
  Playing playing;
  playing.times = m_buffer.add_with_bounds(times, 1);
  playing.weights = m_buffer.add(weights, 1);
  return playing;
}

Json Gltf_scene::scene() const
{
  std::vector<std::size_t> nodes(1 + m_features.number_of_features());
  std::iota(nodes.begin(), nodes.end(), 0);
  Json extras = {{"frames", m_scene.sequence.number_of_frames()},
                 {"frame_duration", m_scene.sequence.frame_duration()}};
  if (m_surface.has_colours()) {
    extras["colour"] = m_scene.fields.front().name;
    extras["top_of_scale"] = m_surface.top();
  }
  return {{"name", m_scene.title}, {"nodes", nodes}, {"extras", std::move(extras)}};
}

Json Gltf_scene::animation() const
{
  Json samplers =
      Json::array({{{"input", m_playing.times}, {"output", m_playing.weights}, {"interpolation", "LINEAR"}}});
  m_features.append_samplers(samplers);
  Json channels = Json::array(); // in the order of samplers
  const auto append = [&](std::size_t node, const char* path) {
    channels.push_back({{"sampler", channels.size()}, {"target", {{"node", node}, {"path", path}}}});
  };
  append(0, "weights");
  for (std::size_t k = 0; k < m_features.number_of_features(); ++k) {
    append(1 + k, "translation");
    append(1 + k, "scale");
  }
  return {{"name", m_scene.title}, {"samplers", std::move(samplers)}, {"channels", std::move(channels)}};
}

} // namespace Programs
