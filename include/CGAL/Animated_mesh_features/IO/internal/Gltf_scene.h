// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_SCENE_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_SCENE_H

#include <CGAL/Animated_mesh_features/IO/Scene.h>
#include <CGAL/Animated_mesh_features/IO/feature_in_frame.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_buffer.h>
#include <CGAL/Animated_mesh_features/IO/internal/for_each_frame.h>
#include <CGAL/Animated_mesh_features/IO/internal/scene_colours.h>
#include <CGAL/Animated_mesh_features/IO/internal/surface_shapes.h>
#include <CGAL/Animated_mesh_features/IO/write_json.h>
#include <CGAL/Animated_mesh_features/Rest_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// A scene as glTF has it.
//
// The surface is one mesh with a morph target for each frame, which holds the differences from frame 0; the weight of a
// target is 1 at the time of its frame and 0 at those of others, so that positions are linear between frames. Each
// feature is a node with a sphere: its translation follows the surface, its scale is its radius in the frames in which it
// lives and 0 in others, which is how glTF hides a node.
template <class Sequence, class Feature>
class Gltf_scene
{
  typedef Scene<Sequence, Feature> Shown_scene;
  typedef std::vector<std::uint8_t> Colours; // RGBA

public:
  explicit Gltf_scene(const Shown_scene& scene)
    : m_scene(scene)
    , m_triangles(scene.sequence.rest_shape().triangles())
    , m_vertices(scene.sequence.number_of_vertices())
    , m_frames(scene.sequence.number_of_frames())
    , m_clock(scene.sequence.frame_duration())
  {
    if (!scene.fields.empty()) m_top = top_of_scale(*scene.fields.front().values);
    if (!scene.features.empty()) {
      choose_colours();
      add_sphere();
      add_features();
    }
    add_clock();
    add_surface();
  }

  // of the binary part, in bytes
  std::size_t size() const { return m_buffer.size(); }

  std::string json() const
  {
    std::ostringstream os;
    Json_output out(os);
    out.raw("{\"asset\":{\"version\":\"2.0\"").raw(",").member("generator", "Animated_mesh_features for CGAL");
    out.raw("},\n\"scene\":0,\"scenes\":[{").member("name", m_scene.title).raw(",\"nodes\":[0");
    for (std::size_t i = 0; i < m_scene.features.size(); ++i) out.raw("," + std::to_string(i + 1));
    out.raw("],\"extras\":{").member("frames", m_frames).raw(",").member("frame_duration", m_clock);
    if (has_colours())
      out.raw(",").member("colour", m_scene.fields.front().name).raw(",").member("top_of_scale", m_top);
    out.raw("}}],\n");
    write_nodes(out);
    write_meshes(out);
    write_materials(out);
    write_animation(out);
    m_buffer.write(out);
    out.raw("}").flush();
    return os.str();
  }

  void write_binary(std::ostream& os) const
  {
    os.write(m_buffer.data().data(), static_cast<std::streamsize>(m_buffer.data().size()));
    for_each_frame(m_scene, [&](const Scene_frame& frame) {
      std::string bytes;
      append_difference(bytes, frame.xyz, m_positions);
      append_difference(bytes, vertex_normals(frame.xyz, m_triangles), m_normals);
      if (has_colours()) {
        std::vector<std::int8_t> differences;
        for (std::size_t v = 0; v < m_vertices; ++v) {
          const auto now = colour(frame.fields.front()[v]);
          for (std::size_t c = 0; c < 4; ++c)
            differences.push_back(c == 3 ? std::int8_t(0)
                                         : std::int8_t(std::lround(127 * (now[c] - m_colours[4 * v + c] / 255.))));
        }
        append_little_endian(bytes, differences.data(), differences.size());
      }
      os.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
  }

private:
  // The life of one feature: accessors of its samplers, and what it is like in frame 0.
  struct Life
  {
    std::size_t times, places, switch_times, sizes;
    std::array<double, 3> place;
    double size;
  };

  struct Target
  {
    std::size_t position, normal, colour;
  };

  bool has_colours() const { return !m_scene.fields.empty(); }

  // Materials of features: near enough to what tau itself would give, and few.
  static constexpr std::size_t tau_steps = 17;

  void choose_colours()
  {
    for (double place : relative_taus(m_scene.features)) {
      const std::size_t step = std::size_t(std::lround(place * double(tau_steps - 1)));
      const auto known = std::find(m_steps.begin(), m_steps.end(), step);
      m_looks.push_back(std::size_t(known - m_steps.begin()));
      if (known == m_steps.end()) m_steps.push_back(step);
    }
  }

  Linear_rgb colour(double value) const
  {
    return field_colour(m_top > 0 ? (std::min)(1., (std::max)(0., value / m_top)) : 0);
  }

  float time(double frame) const { return static_cast<float>(frame * m_clock); }

  void add_sphere()
  {
    const Unit_sphere sphere(3);
    m_buffer.begin_view(Gltf_buffer::VERTICES);
    m_sphere = m_buffer.add(sphere.xyz, 3, true);
    m_buffer.begin_view(Gltf_buffer::TRIANGLES);
    m_sphere_corners = m_buffer.add(sphere.corners, 1);
  }

  void add_features()
  {
    m_buffer.begin_view(Gltf_buffer::ANIMATION);
    for (const Feature& feature : m_scene.features) {
      std::size_t first = feature.frame, last = feature.frame;
      while (first > 0 && lives_in_frame(feature, first - 1, m_clock)) --first;
      while (last + 1 < m_frames && lives_in_frame(feature, last + 1, m_clock)) ++last;
      std::vector<float> times, places;
      for (std::size_t f = first; f <= last; ++f) {
        times.push_back(time(double(f)));
        for (double x : position_in_frame(m_scene.sequence, feature, f)) places.push_back(static_cast<float>(x));
      }
      // Sampled at the times of frames, it is there in its frames and in no other, however times are rounded.
      const float radius = static_cast<float>(feature.radius());
      std::vector<float> switch_times = {0}, sizes(3, first == 0 ? radius : 0);
      const auto add_switch = [&](double frame, float size) {
        switch_times.push_back(time(frame));
        sizes.insert(sizes.end(), 3, size);
      };
      if (first > 0) add_switch(double(first) - 0.5, radius);
      if (last + 1 < m_frames) add_switch(double(last) + 0.5, 0);
      m_lives.push_back({m_buffer.add(times, 1, true),
                         m_buffer.add(places, 3),
                         m_buffer.add(switch_times, 1, true),
                         m_buffer.add(sizes, 3),
                         {{places[0], places[1], places[2]}},
                         sizes[0]});
    }
  }

  void add_clock()
  {
    std::vector<float> times, weights(m_frames * m_frames, 0);
    for (std::size_t f = 0; f < m_frames; ++f) {
      times.push_back(time(double(f)));
      weights[f * m_frames + f] = 1;
    }
    m_buffer.begin_view(Gltf_buffer::ANIMATION);
    m_times = m_buffer.add(times, 1, true);
    m_weights = m_buffer.add(weights, 1);
  }

  // Triangles and frame 0; the places of the frames, with the bounds of the differences.
  void add_surface()
  {
    std::vector<std::uint32_t> corners;
    for (const auto& t : m_triangles) corners.insert(corners.end(), t.begin(), t.end());
    m_buffer.begin_view(Gltf_buffer::TRIANGLES);
    m_corners = m_buffer.add(corners, 1);

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
    m_buffer.begin_view(Gltf_buffer::VERTICES, 12);
    m_base.position = m_buffer.add(m_positions, 3, true);
    m_base.normal = m_buffer.add(m_normals, 3);
    if (has_colours()) {
      for (float value : most) {
        for (double x : colour(value)) m_colours.push_back(std::uint8_t(std::lround(255 * x)));
        m_colours.push_back(255);
      }
      m_buffer.begin_view(Gltf_buffer::VERTICES);
      m_base.colour = m_buffer.add(m_colours, 4);
    }
    for (const Gltf_buffer::Bounds& b : bounds) {
      m_buffer.begin_view(Gltf_buffer::VERTICES, 12);
      Target target;
      target.position = m_buffer.reserve<float>(m_vertices, 3, b);
      target.normal = m_buffer.reserve<float>(m_vertices, 3);
      if (has_colours()) {
        m_buffer.begin_view(Gltf_buffer::VERTICES);
        target.colour = m_buffer.reserve<std::int8_t>(m_vertices, 4);
      }
      m_targets.push_back(target);
    }
  }

  static void append_difference(std::string& bytes, std::vector<float> values, const std::vector<float>& base)
  {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= base[i];
    append_little_endian(bytes, values.data(), values.size());
  }

  void write_nodes(Json_output& out) const
  {
    out.raw("\"nodes\":[\n{\"name\":\"surface\",\"mesh\":0}");
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
    out.raw("],\n");
  }

  void write_meshes(Json_output& out) const
  {
    const auto attributes = [&](const Target& t) {
      out.raw("{").member("POSITION", t.position).raw(",").member("NORMAL", t.normal);
      if (has_colours()) out.raw(",").member("COLOR_0", t.colour);
      out.raw("}");
    };
    out.raw("\"meshes\":[\n{\"name\":\"surface\",\"primitives\":[{\"attributes\":");
    attributes(m_base);
    out.raw(",").member("indices", m_corners).raw(",\"material\":0,\"targets\":[");
    const char* separator = "\n";
    for (const Target& t : m_targets) {
      out.raw(separator);
      attributes(t);
      separator = ",\n";
    }
    std::vector<std::string> names;
    for (std::size_t f = 0; f < m_frames; ++f) names.push_back("frame " + std::to_string(f));
    std::vector<int> weights(m_frames, 0);
    weights[0] = 1;
    out.raw("]}],\n").member("weights", weights).raw(",\"extras\":{").member("targetNames", names).raw("}}");
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
      out.raw(",\n{").member("name", tau_name(m_steps[i])).raw(",\"primitives\":[{\"attributes\":{");
      out.member("POSITION", m_sphere).raw(",").member("NORMAL", m_sphere).raw("},");
      out.member("indices", m_sphere_corners).raw(",").member("material", 1 + i).raw("}]}");
    }
    out.raw("],\n");
  }

  static std::string tau_name(std::size_t step)
  {
    return "tau " + std::to_string(step) + " of " + std::to_string(tau_steps - 1);
  }

  void write_materials(Json_output& out) const
  {
    const double opacity = 0.6; // the surface is to be seen within
    const auto material = [&](const std::string& name, const Linear_rgb& c, double alpha, double roughness) {
      out.raw("{").member("name", name).raw(",\"pbrMetallicRoughness\":{");
      out.member("baseColorFactor", std::array<double, 4>{{c[0], c[1], c[2], alpha}});
      out.raw(",\"metallicFactor\":0,").member("roughnessFactor", roughness).raw("}");
      if (alpha < 1) out.raw(",\"alphaMode\":\"BLEND\"");
    };
    out.raw("\"materials\":[\n");
    material("surface", has_colours() ? Linear_rgb{{1, 1, 1}} : field_colour(0), 1, 0.8);
    out.raw(",\"doubleSided\":true}"); // it may have a border, or be inside out
    for (std::size_t step : m_steps) {
      out.raw(",\n");
      material(tau_name(step), tau_colour(double(step) / double(tau_steps - 1)), opacity, 0.5);
      out.raw("}");
    }
    out.raw("],\n");
  }

  void write_animation(Json_output& out) const
  {
    out.raw("\"animations\":[{").member("name", m_scene.title).raw(",\"samplers\":[");
    const char* separator = "\n{";
    const auto sampler = [&](std::size_t input, std::size_t output, const char* interpolation) {
      out.raw(separator).member("input", input).raw(",").member("output", output);
      out.raw(",").member("interpolation", interpolation).raw("}");
      separator = ",\n{";
    };
    sampler(m_times, m_weights, "LINEAR");
    for (const Life& life : m_lives) {
      sampler(life.times, life.places, "LINEAR");
      sampler(life.switch_times, life.sizes, "STEP");
    }
    out.raw("],\"channels\":[");
    separator = "\n{";
    std::size_t i = 0;
    const auto channel = [&](std::size_t node, const char* path) {
      out.raw(separator).member("sampler", i++).raw(",\"target\":{").member("node", node);
      out.raw(",").member("path", path).raw("}}");
      separator = ",\n{";
    };
    channel(0, "weights");
    for (std::size_t k = 0; k < m_lives.size(); ++k) {
      channel(1 + k, "translation");
      channel(1 + k, "scale");
    }
    out.raw("]}],\n");
  }

  const Shown_scene& m_scene;
  const std::vector<Rest_shape::Triangle>& m_triangles;
  std::size_t m_vertices, m_frames;
  double m_clock;
  double m_top = 0; // of the scale of colours
  Gltf_buffer m_buffer;
  std::size_t m_sphere = 0, m_sphere_corners = 0, m_times = 0, m_weights = 0, m_corners = 0; // accessors
  Target m_base = {0, 0, 0};
  std::vector<Target> m_targets;
  std::vector<Life> m_lives;
  std::vector<std::size_t> m_steps, m_looks; // the colours that there are; which of them each feature has
  std::vector<float> m_positions, m_normals; // in frame 0
  Colours m_colours;                         // of the largest value of each vertex
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_SCENE_H
