// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_GLTF_SCENE_H
#define PROGRAMS_SCENES_GLTF_SCENE_H

#include "scenes/Scene.h"
#include "scenes/Gltf_buffer.h"
#include "scenes/Gltf_features.h"
#include "scenes/Gltf_surface.h"
#include <CGAL/Animated_mesh_features/IO/write_json.h>

#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// A scene as glTF has it: the JSON, and the binary part behind it. The weight of a frame's morph target is 1 at the time of
// the frame and 0 at those of others, so that positions are linear between frames.
template <class Sequence, class Feature>
class Gltf_scene
{
public:
  explicit Gltf_scene(const Scene<Sequence, Feature>& scene)
    : m_scene(scene)
    , m_features(scene, m_buffer)
    , m_frame_duration(add_clock())
    , m_surface(scene, m_buffer)
  {}

  // of the binary part, in bytes
  std::size_t size() const { return m_buffer.size(); }

  std::string json() const
  {
    std::ostringstream os;
    Json_output out(os);
    out.raw("{\"asset\":{\"version\":\"2.0\",\"generator\":\"Animated_mesh_features for CGAL\"},\n");
    out.raw("\"scene\":0,\"scenes\":[{").member("name", m_scene.title).raw(",\"nodes\":[0");
    for (std::size_t i = 0; i < m_features.number_of_features(); ++i) out.raw("," + std::to_string(i + 1));
    out.raw("],\"extras\":{").member("frames", m_scene.sequence.number_of_frames());
    out.raw(",").member("frame_duration", m_scene.sequence.frame_duration());
    if (m_surface.has_colours())
      out.raw(",").member("colour", m_scene.fields.front().name).raw(",").member("top_of_scale", m_surface.top());
    out.raw("}}],\n\"nodes\":[\n{\"name\":\"surface\",\"mesh\":0}");
    m_features.write_nodes(out);
    out.raw("],\n\"meshes\":[");
    m_surface.write_mesh(out);
    m_features.write_meshes(out);
    out.raw("],\n\"materials\":[");
    m_surface.write_material(out);
    m_features.write_materials(out);
    out.raw("],\n\"animations\":[{").member("name", m_scene.title).raw(",\"samplers\":[\n{");
    out.member("input", m_frame_duration.times).raw(",").member("output", m_frame_duration.weights);
    out.raw(",\"interpolation\":\"LINEAR\"}");
    m_features.write_samplers(out);
    out.raw("],\"channels\":[");
    write_channels(out);
    out.raw("]}],\n");
    m_buffer.write(out);
    out.raw("}").flush();
    return os.str();
  }

  void write_binary(std::ostream& os) const
  {
    os.write(m_buffer.data().data(), static_cast<std::streamsize>(m_buffer.data().size()));
    m_surface.write_targets(os);
  }

private:
  struct Clock // accessors
  {
    std::size_t times, weights;
  };

  Clock add_clock()
  {
    const std::size_t frames = m_scene.sequence.number_of_frames();
    std::vector<float> times, weights(frames * frames, 0);
    for (std::size_t f = 0; f < frames; ++f) {
      times.push_back(static_cast<float>(double(f) * m_scene.sequence.frame_duration()));
      weights[f * frames + f] = 1;
    }
    m_buffer.begin_view(Gltf_buffer::ANIMATION);
    Clock clock;
    clock.times = m_buffer.add(times, 1, true);
    clock.weights = m_buffer.add(weights, 1);
    return clock;
  }

  // In the order of samplers.
  void write_channels(Json_output& out) const
  {
    std::size_t i = 0;
    const auto channel = [&](std::size_t node, const char* path) {
      out.raw(i == 0 ? "\n{" : ",\n{").member("sampler", i).raw(",\"target\":{").member("node", node);
      out.raw(",").member("path", path).raw("}}");
      ++i;
    };
    channel(0, "weights");
    for (std::size_t k = 0; k < m_features.number_of_features(); ++k) {
      channel(1 + k, "translation");
      channel(1 + k, "scale");
    }
  }

  const Scene<Sequence, Feature>& m_scene;
  Gltf_buffer m_buffer; // before those that fill it, in the order of its content
  Gltf_features<Sequence, Feature> m_features;
  Clock m_frame_duration;
  Gltf_surface<Sequence, Feature> m_surface;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_SCENES_GLTF_SCENE_H
