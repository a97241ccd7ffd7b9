// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_GLTF_FEATURES_H
#define PROGRAMS_SCENES_GLTF_FEATURES_H

#include "scenes/Scene.h"
#include "scenes/feature_in_frame.h"
#include "scenes/Gltf_buffer.h"
#include "scenes/colour_scales.h"
#include "rendering/Palette.h"
#include "scenes/surface_shapes.h"
#include <CGAL/Animated_mesh_features/IO/write_json.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// The features of a scene as glTF has them: a node for each, with a sphere. Its translation follows the surface, its scale
// is its radius in the frames in which it lives and 0 in others, which is how glTF hides a node.
template <class Sequence, class Feature>
class Gltf_features
{
public:
  Gltf_features(const Scene<Sequence, Feature>& scene, Gltf_buffer& buffer)
    : m_scene(scene)
  {
    if (scene.features.empty()) return;
    choose_colours();
    add_sphere(buffer);
    buffer.begin_view(Gltf_buffer::ANIMATION);
    for (const Feature& feature : scene.features) add_life(feature, buffer);
  }

  std::size_t number_of_features() const { return m_lives.size(); }

  // Each of the following writes elements of an array that has one already. Meshes and materials are numbered from 1.

  void write_nodes(Json_output& out) const
  {
    for (std::size_t i = 0; i < m_lives.size(); ++i) {
      const Feature& f = m_scene.features[i];
      const double size = m_lives[i].size;
      out.raw(",\n{").member("name", "feature_" + std::to_string(i)).raw(",").member("mesh", 1 + m_looks[i]);
      out.raw(",").member("translation", m_lives[i].place);
      out.raw(",").member("scale", std::array<double, 3>{{size, size, size}});
      out.raw(",\"extras\":{").member("rank", i).raw(",").member("vertex", f.vertex_index);
      out.raw(",").member("frame", f.frame).raw(",").member("time", f.time);
      out.raw(",").member("sigma", f.sigma).raw(",").member("tau", f.tau).raw(",").member("radius", f.radius());
      out.raw(",").member("strength", f.strength()).raw(",").member("at_scale_limit", f.at_scale_limit).raw("}}");
    }
  }

  void write_meshes(Json_output& out) const
  {
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
      out.raw(",\n{").member("name", name(m_steps[i])).raw(",\"primitives\":[{\"attributes\":{");
      out.member("POSITION", m_sphere).raw(",").member("NORMAL", m_sphere).raw("},");
      out.member("indices", m_sphere_corners).raw(",").member("material", 1 + i).raw("}]}");
    }
  }

  void write_materials(Json_output& out) const
  {
    const float opacity = 0.6f; // the surface is to be seen within
    for (std::size_t step : m_steps) {
      const auto c = Programs::Rendering::duration_colours()(double(step) / double(tau_steps - 1));
      out.raw(",\n{").member("name", name(step)).raw(",\"pbrMetallicRoughness\":{");
      out.member("baseColorFactor", std::array<float, 4>{{c[0], c[1], c[2], opacity}});
      out.raw(",\"metallicFactor\":0,\"roughnessFactor\":0.5},\"alphaMode\":\"BLEND\"}");
    }
  }

  // Two for each feature, of its translation and its scale.
  void write_samplers(Json_output& out) const
  {
    const auto sampler = [&](std::size_t input, std::size_t output, const char* interpolation) {
      out.raw(",\n{").member("input", input).raw(",").member("output", output);
      out.raw(",").member("interpolation", interpolation).raw("}");
    };
    for (const Life& life : m_lives) {
      sampler(life.times, life.places, "LINEAR");
      sampler(life.switch_times, life.sizes, "STEP");
    }
  }

private:
  // Accessors of the samplers of a feature, and what it is like in frame 0.
  struct Life
  {
    std::size_t times, places, switch_times, sizes;
    std::array<double, 3> place;
    double size;
  };

  // So many colours are near enough to what tau itself would give, and few materials.
  static constexpr std::size_t tau_steps = 17;

  static std::string name(std::size_t step)
  {
    return "tau " + std::to_string(step) + " of " + std::to_string(tau_steps - 1);
  }

  void choose_colours()
  {
    for (double place : relative_taus(m_scene.features)) {
      const std::size_t step = std::size_t(std::lround(place * double(tau_steps - 1)));
      const auto known = std::find(m_steps.begin(), m_steps.end(), step);
      m_looks.push_back(std::size_t(known - m_steps.begin()));
      if (known == m_steps.end()) m_steps.push_back(step);
    }
  }

  void add_sphere(Gltf_buffer& buffer)
  {
    const int subdivisions = 3; // 512 triangles: round enough, and there is one sphere for all
    const Unit_sphere sphere(subdivisions);
    buffer.begin_view(Gltf_buffer::VERTICES);
    m_sphere = buffer.add(sphere.xyz, 3, true);
    buffer.begin_view(Gltf_buffer::TRIANGLES);
    m_sphere_corners = buffer.add(sphere.corners, 1);
  }

  void add_life(const Feature& feature, Gltf_buffer& buffer)
  {
    const std::size_t frames = m_scene.sequence.number_of_frames();
    const double clock = m_scene.sequence.frame_duration();
    std::size_t first = feature.frame, last = feature.frame;
    while (first > 0 && lives_in_frame(feature, first - 1, clock)) --first;
    while (last + 1 < frames && lives_in_frame(feature, last + 1, clock)) ++last;
    std::vector<float> times, places;
    for (std::size_t f = first; f <= last; ++f) {
      times.push_back(static_cast<float>(double(f) * clock));
      for (double x : position_in_frame(m_scene.sequence, feature, f)) places.push_back(static_cast<float>(x));
    }
    // Sampled at the times of frames, it is there in its frames and in no other, however times are rounded.
    const float radius = static_cast<float>(feature.radius());
    std::vector<float> switch_times = {0}, sizes(3, first == 0 ? radius : 0);
    const auto add_switch = [&](double frame, float size) {
      switch_times.push_back(static_cast<float>(frame * clock));
      sizes.insert(sizes.end(), 3, size);
    };
    if (first > 0) add_switch(double(first) - 0.5, radius);
    if (last + 1 < frames) add_switch(double(last) + 0.5, 0);
    Life life;
    life.place = {{places[0], places[1], places[2]}};
    life.size = sizes[0];
    life.times = buffer.add(times, 1, true);
    life.places = buffer.add(places, 3);
    life.switch_times = buffer.add(switch_times, 1, true);
    life.sizes = buffer.add(sizes, 3);
    m_lives.push_back(life);
  }

  const Scene<Sequence, Feature>& m_scene;
  std::size_t m_sphere = 0, m_sphere_corners = 0; // accessors
  std::vector<Life> m_lives;
  std::vector<std::size_t> m_steps, m_looks; // the colours that there are; which of them each feature has
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_SCENES_GLTF_FEATURES_H
