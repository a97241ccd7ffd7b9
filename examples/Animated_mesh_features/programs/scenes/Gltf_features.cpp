// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/Gltf_features.h"

#include "rendering/Palette.h"
#include "scenes/colour_scales.h"
#include "scenes/feature_in_frame.h"
#include "scenes/surface_shapes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>

typedef nlohmann::ordered_json Json;

namespace Programs {

namespace {

// So many colours are near enough to what tau itself would give, and few materials.
constexpr std::size_t tau_steps = 17;

std::string name_of_step(std::size_t step)
{
  return "tau " + std::to_string(step) + " of " + std::to_string(tau_steps - 1);
}

} // namespace

Gltf_features::Gltf_features(const Shown_scene& scene, Gltf_buffer& buffer)
  : m_scene(scene)
{
  if (scene.features.empty()) return;
  choose_colours();
  add_sphere(buffer);
  buffer.begin_view(Gltf_buffer::ANIMATION);
  for (const Shown_feature& feature : scene.features) add_life(feature, buffer);
}

void Gltf_features::append_nodes(Json& nodes) const
{
  for (std::size_t i = 0; i < m_lives.size(); ++i) {
    const Shown_feature& f = m_scene.features[i];
    const float size = m_lives[i].size;
    nodes.push_back({{"name", "feature_" + std::to_string(i + 1)},
                     {"mesh", 1 + m_looks[i]},
                     {"translation", m_lives[i].place},
                     {"scale", {size, size, size}},
                     {"extras",
                      {{"rank", i + 1},
                       {"vertex", f.vertex_index},
                       {"frame", f.frame},
                       {"time", f.time},
                       {"sigma", f.sigma},
                       {"tau", f.tau},
                       {"radius", f.radius()},
                       {"amplitude", f.amplitude},
                       {"fit", f.fit},
                       {"strength", f.strength},
                       {"place", f.place + 1},
                       {"parent", f.parent == Shown_feature::none ? Json(nullptr) : Json(f.parent + 1)},
                       {"at_scale_limit", f.at_scale_limit}}}});
  }
}

void Gltf_features::append_meshes(Json& meshes) const
{
  for (std::size_t i = 0; i < m_steps.size(); ++i) {
    const Json primitive = {{"attributes", {{"POSITION", m_sphere}, {"NORMAL", m_sphere}}},
                            {"indices", m_sphere_corners},
                            {"material", 1 + i}};
    meshes.push_back({{"name", name_of_step(m_steps[i])}, {"primitives", Json::array({primitive})}});
  }
}

void Gltf_features::append_materials(Json& materials) const
{
  const float opacity = 0.6f; // the surface is to be seen within
  for (std::size_t step : m_steps) {
    const auto c = Rendering::duration_colours()(double(step) / double(tau_steps - 1));
    materials.push_back(
        {{"name", name_of_step(step)},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {c[0], c[1], c[2], opacity}}, {"metallicFactor", 0}, {"roughnessFactor", 0.5}}},
         {"alphaMode", "BLEND"}});
  }
}

void Gltf_features::append_samplers(Json& samplers) const
{
  const auto append = [&](std::size_t input, std::size_t output, const char* interpolation) {
    samplers.push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
  };
  for (const Life& life : m_lives) {
    append(life.times, life.places, "LINEAR");
    append(life.switch_times, life.sizes, "STEP");
  }
}

void Gltf_features::choose_colours()
{
  for (double place : relative_taus(m_scene.features)) {
    const std::size_t step = std::size_t(std::lround(place * double(tau_steps - 1)));
    const auto known = std::find(m_steps.begin(), m_steps.end(), step);
    m_looks.push_back(std::size_t(known - m_steps.begin()));
    if (known == m_steps.end()) m_steps.push_back(step);
  }
}

void Gltf_features::add_sphere(Gltf_buffer& buffer)
{
  const int subdivisions = 3; // 512 triangles: round enough, and there is one sphere for all
  const Unit_sphere sphere(subdivisions);
  buffer.begin_view(Gltf_buffer::VERTICES);
  m_sphere = buffer.add_with_bounds(sphere.xyz, 3);
  buffer.begin_view(Gltf_buffer::TRIANGLES);
  m_sphere_corners = buffer.add(sphere.corners, 1);
}

void Gltf_features::add_life(const Shown_feature& feature, Gltf_buffer& buffer)
{
  const std::size_t frames = m_scene.sequence.number_of_frames();
  const double duration = m_scene.sequence.frame_duration();
  const auto lives = [&](std::size_t f) { return lives_in_frame(feature, f, duration, period(m_scene)); };
  // Sampled at the times of frames, it is there in its frames and in no other, however times are rounded.
  const float radius = static_cast<float>(feature.radius());
  std::vector<float> times, places, switch_times = {0}, sizes(3, lives(0) ? radius : 0);
  for (std::size_t f = 0; f < frames; ++f) {
    if (f > 0 && lives(f) != lives(f - 1)) {
      switch_times.push_back(static_cast<float>((double(f) - 0.5) * duration));
      sizes.insert(sizes.end(), 3, lives(f) ? radius : 0);
    }
    if (!lives(f)) continue;
    times.push_back(static_cast<float>(double(f) * duration));
    for (double x : position_in_frame(m_scene.sequence, feature, f)) places.push_back(static_cast<float>(x));
  }
  Life life;
  life.place = {{places[0], places[1], places[2]}};
  life.size = sizes[0];
  life.times = buffer.add_with_bounds(times, 1);
  life.places = buffer.add(places, 3);
  life.switch_times = buffer.add_with_bounds(switch_times, 1);
  life.sizes = buffer.add(sizes, 3);
  m_lives.push_back(life);
}

} // namespace Programs
