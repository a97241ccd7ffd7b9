// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_READ_GLTF_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_READ_GLTF_H

#include <CGAL/Animated_mesh_features/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_accessor_reader.h>
#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>
#include <CGAL/Animated_mesh_features/IO/internal/skin_influences.h>

#include <tiny_gltf.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

// tinygltf would decode the images, which nobody looks at.
inline bool ignore_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                         void*)
{
  return true;
}

inline std::string one_line(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

inline void parse_gltf(const std::string& file, tinygltf::Model& model)
{
  std::string content;
  read_content(file, content);
  if (content.size() > (std::numeric_limits<unsigned int>::max)()) throw Input_error(file + ": is larger than 4 GB");
  const unsigned int size = static_cast<unsigned int>(content.size());
  const std::string folder = std::filesystem::path(file).parent_path().string();
  tinygltf::TinyGLTF parser;
  parser.SetImageLoader(ignore_image, nullptr);
  std::string error, warning;
  const bool is_binary = content.compare(0, 4, "glTF") == 0;
  const bool is_read =
      is_binary ? parser.LoadBinaryFromMemory(&model, &error, &warning,
                                              reinterpret_cast<const unsigned char*>(content.data()), size, folder)
                : parser.LoadASCIIFromString(&model, &error, &warning, content.data(), size, folder);
  if (!is_read) throw Input_error(file + ": is no readable glTF 2.0: " + one_line(error));
  if (model.asset.version.compare(0, 1, "2") != 0)
    throw Input_error(file + ": is glTF " + model.asset.version + ", not glTF 2.0");
  // Those that change what a triangle or an animation is are not known here; those of materials change nothing.
  for (const std::string& extension : model.extensionsRequired) {
    bool is_harmless = extension == "KHR_mesh_quantization" || extension == "KHR_lights_punctual";
    for (const char* kind : {"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_"})
      is_harmless = is_harmless || extension.compare(0, std::string(kind).size(), kind) == 0;
    if (!is_harmless) throw Input_error(file + ": needs the extension " + extension + ", which is not supported");
  }
}

// Makes a Keyframed_model of what tinygltf has parsed.
class Gltf_model_builder
{
public:
  Gltf_model_builder(const tinygltf::Model& gltf, const std::string& file)
    : m_gltf(gltf)
    , m_file(file)
    , m_accessors(gltf, file)
  {}

  Keyframed_model operator()()
  {
    for (const tinygltf::Node& node : m_gltf.nodes) add_node(node);
    connect_nodes();
    for (std::size_t i = 0; i < m_gltf.skins.size(); ++i) add_skin(i);
    add_scene();
    for (std::size_t i = 0; i < m_gltf.animations.size(); ++i) add_clip(i);
    if (m_without_triangles > 0)
      m_model.remarks.push_back(std::to_string(m_without_triangles) +
                                " of the meshes' primitives left out: points or lines");
    if (!m_gltf.asset.copyright.empty())
      m_model.remarks.push_back("the author's notice in the file: " + one_line(m_gltf.asset.copyright));
    return std::move(m_model);
  }

private:
  static constexpr std::size_t none = Keyframed_model::none;

  template <std::size_t n>
  void copy(const std::vector<double>& from, std::array<double, n>& to, const std::string& name) const
  {
    if (from.empty()) return;
    if (from.size() != n) fail(name + " has " + std::to_string(from.size()) + " numbers, not " + std::to_string(n));
    std::copy(from.begin(), from.end(), to.begin());
  }

  static Eigen::Affine3d affine(const double* column_major)
  {
    Eigen::Affine3d a;
    a.matrix() = Eigen::Map<const Eigen::Matrix4d>(column_major);
    a.makeAffine();
    return a;
  }

  void add_node(const tinygltf::Node& from)
  {
    const std::string name = node_name(m_model.nodes.size());
    Keyframed_model::Node node;
    node.name = from.name;
    if (!from.matrix.empty()) {
      std::array<double, 16> matrix;
      copy(from.matrix, matrix, name + ": the matrix");
      node.matrix = affine(matrix.data());
    }
    copy(from.translation, node.translation, name + ": the translation");
    copy(from.rotation, node.rotation, name + ": the rotation");
    copy(from.scale, node.scale, name + ": the scale");
    m_model.nodes.push_back(node);
  }

  void connect_nodes()
  {
    for (std::size_t i = 0; i < m_gltf.nodes.size(); ++i)
      for (int child : m_gltf.nodes[i].children) {
        Keyframed_model::Node& node = m_model.nodes[checked(child, m_model.nodes.size(), node_name(i) + ": child")];
        if (node.parent != none) fail(node_name(std::size_t(child)) + " has two parents");
        node.parent = i;
      }
  }

  void add_skin(std::size_t i)
  {
    const tinygltf::Skin& from = m_gltf.skins[i];
    const std::string name = "skin " + std::to_string(i);
    Keyframed_model::Skin skin;
    for (int joint : from.joints) skin.joints.push_back(checked(joint, m_model.nodes.size(), name + ": joint"));
    skin.inverse_binds.assign(skin.joints.size(), Eigen::Affine3d::Identity());
    if (from.inverseBindMatrices >= 0) {
      const std::vector<double> matrices = m_accessors.read(from.inverseBindMatrices, 16, name);
      if (matrices.size() < 16 * skin.joints.size()) fail(name + " has fewer inverse bind matrices than joints");
      for (std::size_t j = 0; j < skin.joints.size(); ++j) skin.inverse_binds[j] = affine(&matrices[16 * j]);
    }
    m_model.skins.push_back(std::move(skin));
  }

  // The meshes of the nodes below the scene's, in the order of the nodes.
  void add_scene()
  {
    std::vector<std::size_t> waiting;
    if (!m_gltf.scenes.empty()) {
      const int scene = (std::max)(m_gltf.defaultScene, 0);
      for (int root : m_gltf.scenes[checked(scene, m_gltf.scenes.size(), "default scene")].nodes)
        waiting.push_back(checked(root, m_gltf.nodes.size(), "node of a scene"));
    } else {
      for (std::size_t i = 0; i < m_model.nodes.size(); ++i)
        if (m_model.nodes[i].parent == none) waiting.push_back(i);
    }
    std::vector<char> is_drawn(m_gltf.nodes.size(), 0);
    while (!waiting.empty()) {
      const std::size_t i = waiting.back();
      waiting.pop_back();
      if (is_drawn[i]) continue;
      is_drawn[i] = 1;
      for (int child : m_gltf.nodes[i].children) waiting.push_back(std::size_t(child));
    }
    for (std::size_t i = 0; i < m_gltf.nodes.size(); ++i)
      if (is_drawn[i] && m_gltf.nodes[i].mesh >= 0) add_parts(i);
  }

  void add_parts(std::size_t n)
  {
    const tinygltf::Node& node = m_gltf.nodes[n];
    const std::size_t mesh_index = checked(node.mesh, m_gltf.meshes.size(), node_name(n) + ": mesh");
    const tinygltf::Mesh& mesh = m_gltf.meshes[mesh_index];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const std::string name =
          node_name(n) + ", mesh " + std::to_string(mesh_index) + ", primitive " + std::to_string(p);
      const auto known = m_geometries.find({mesh_index, p});
      const std::size_t geometry = known != m_geometries.end() ? known->second : add_geometry(mesh.primitives[p], name);
      m_geometries[{mesh_index, p}] = geometry;
      if (geometry == none) continue;
      Keyframed_model::Part part;
      part.geometry = geometry;
      part.node = n;
      part.name = name;
      if (node.skin >= 0 && !m_model.geometries[geometry].first_influence.empty())
        part.skin = checked(node.skin, m_model.skins.size(), name + ": skin");
      part.weights = !node.weights.empty() ? node.weights : mesh.weights;
      if (part.weights.empty()) part.weights.assign(m_model.geometries[geometry].targets.size(), 0);
      m_model.parts.push_back(std::move(part));
    }
  }

  std::size_t add_geometry(const tinygltf::Primitive& primitive, const std::string& name)
  {
    const auto position = primitive.attributes.find("POSITION");
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (position == primitive.attributes.end() ||
        (mode != TINYGLTF_MODE_TRIANGLES && mode != TINYGLTF_MODE_TRIANGLE_STRIP &&
         mode != TINYGLTF_MODE_TRIANGLE_FAN)) {
      ++m_without_triangles;
      return none;
    }
    Keyframed_model::Geometry geometry;
    geometry.points = vectors(position->second, name + ", positions");
    add_triangles(primitive, mode, name, geometry);
    for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
      const auto displacement = primitive.targets[t].find("POSITION");
      geometry.targets.emplace_back();
      if (displacement == primitive.targets[t].end()) continue;
      const std::string target = name + ", morph target " + std::to_string(t);
      geometry.targets.back() = vectors(displacement->second, target);
      if (geometry.targets.back().size() != geometry.points.size()) fail(target + " has another number of vertices");
    }
    add_influences(primitive, name, geometry);
    m_model.geometries.push_back(std::move(geometry));
    return m_model.geometries.size() - 1;
  }

  std::vector<Keyframed_model::Vector> vectors(int accessor, const std::string& name) const
  {
    const std::vector<double> values = m_accessors.read(accessor, 3, name);
    std::vector<Keyframed_model::Vector> result(values.size() / 3);
    for (std::size_t i = 0; i < values.size(); ++i) result[i / 3][i % 3] = values[i];
    return result;
  }

  void add_triangles(const tinygltf::Primitive& primitive, int mode, const std::string& name,
                     Keyframed_model::Geometry& geometry) const
  {
    std::vector<std::size_t> corners;
    if (primitive.indices >= 0) {
      corners = m_accessors.read_indices(primitive.indices, 1, name + ", indices");
    } else {
      for (std::size_t v = 0; v < geometry.points.size(); ++v) corners.push_back(v);
    }
    const auto add = [&](std::size_t i, std::size_t j, std::size_t k) {
      for (std::size_t c : {corners[i], corners[j], corners[k]})
        if (c >= geometry.points.size())
          fail(name + ", triangle " + std::to_string(geometry.triangles.size()) + " has a corner at vertex " +
               std::to_string(c) + ", there are " + std::to_string(geometry.points.size()) + " vertices");
      // Strips are tied together by triangles that repeat a vertex.
      if (mode != TINYGLTF_MODE_TRIANGLES &&
          (corners[i] == corners[j] || corners[j] == corners[k] || corners[k] == corners[i]))
        return;
      geometry.triangles.push_back({{corners[i], corners[j], corners[k]}});
    };
    const std::size_t n = corners.size();
    if (mode == TINYGLTF_MODE_TRIANGLES) {
      if (n % 3 != 0) fail(name + " has " + std::to_string(n) + " corners, which do not make triangles");
      for (std::size_t i = 0; i < n; i += 3) add(i, i + 1, i + 2);
    } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      for (std::size_t i = 0; i + 2 < n; ++i) add(i, i + 1 + i % 2, i + 2 - i % 2); // every second one the other way
    } else {
      for (std::size_t i = 0; i + 2 < n; ++i) add(i + 1, i + 2, 0);
    }
  }

  void add_influences(const tinygltf::Primitive& primitive, const std::string& name,
                      Keyframed_model::Geometry& geometry) const
  {
    const std::size_t width = 4;
    std::vector<std::vector<std::size_t>> joints;
    std::vector<std::vector<double>> weights;
    for (std::size_t set = 0;; ++set) {
      const auto j = primitive.attributes.find("JOINTS_" + std::to_string(set));
      const auto w = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
      if (j == primitive.attributes.end() || w == primitive.attributes.end()) break;
      joints.push_back(m_accessors.read_indices(j->second, width, name + ", joints"));
      weights.push_back(m_accessors.read(w->second, width, name + ", weights"));
      if (joints.back().size() != width * geometry.points.size() || weights.back().size() != joints.back().size())
        fail(name + ": joints or weights are not as many as vertices");
    }
    if (joints.empty()) return;
    std::vector<Keyframed_model::Influence> influences;
    for (std::size_t v = 0; v < geometry.points.size(); ++v) {
      influences.clear();
      for (std::size_t set = 0; set < joints.size(); ++set)
        for (std::size_t i = width * v; i < width * (v + 1); ++i)
          influences.push_back({joints[set][i], weights[set][i]});
      append_influences(influences, geometry);
    }
  }

  void add_clip(std::size_t a)
  {
    const tinygltf::Animation& from = m_gltf.animations[a];
    Keyframed_model::Clip clip;
    clip.name = from.name;
    for (std::size_t c = 0; c < from.channels.size(); ++c) {
      const std::string name = "animation " + std::to_string(a) + " (" + from.name + "), channel " + std::to_string(c);
      const tinygltf::AnimationChannel& channel = from.channels[c];
      if (channel.target_node < 0) continue; // to be ignored, says the specification
      Keyframed_model::Channel result;
      result.node = checked(channel.target_node, m_model.nodes.size(), name + ": node");
      if (!set_path(channel.target_path, result)) continue;
      const std::size_t sampler = checked(channel.sampler, from.samplers.size(), name + ": sampler");
      read_track(from.samplers[sampler], name, result);
      clip.channels.push_back(std::move(result));
    }
    m_model.clips.push_back(std::move(clip));
  }

  // false for what extensions move
  static bool set_path(const std::string& path, Keyframed_model::Channel& channel)
  {
    typedef Keyframed_model::Path Path;
    const std::map<std::string, Path> paths = {{"translation", Path::TRANSLATION},
                                               {"rotation", Path::ROTATION},
                                               {"scale", Path::SCALE},
                                               {"weights", Path::WEIGHTS}};
    const auto found = paths.find(path);
    if (found == paths.end()) return false;
    channel.path = found->second;
    channel.track.is_rotation = channel.path == Path::ROTATION;
    return true;
  }

  void read_track(const tinygltf::AnimationSampler& sampler, const std::string& name,
                  Keyframed_model::Channel& channel) const
  {
    typedef Keyframe_track::Interpolation Interpolation;
    Keyframe_track& track = channel.track;
    std::size_t values_per_key = 1;
    if (sampler.interpolation == "STEP") {
      track.interpolation = Interpolation::STEP;
    } else if (sampler.interpolation == "CUBICSPLINE") {
      track.interpolation = Interpolation::CUBICSPLINE;
      values_per_key = 3;
    } else if (sampler.interpolation != "LINEAR") {
      fail(name + ": unknown interpolation " + sampler.interpolation);
    }
    track.times = m_accessors.read(sampler.input, 1, name + ", times");
    if (track.times.empty()) fail(name + " has no keys");
    for (std::size_t k = 1; k < track.times.size(); ++k)
      if (!(track.times[k] > track.times[k - 1]))
        fail(name + ": the time of key " + std::to_string(k) + " does not ascend");
    if (channel.path == Keyframed_model::Path::WEIGHTS) {
      track.values = m_accessors.read(sampler.output, 1, name + ", values");
      track.width = track.values.size() / (values_per_key * track.times.size());
    } else {
      track.width = track.is_rotation ? 4 : 3;
      track.values = m_accessors.read(sampler.output, track.width, name + ", values");
    }
    if (!track.is_complete())
      fail(name + " has " + std::to_string(track.values.size()) + " numbers for " + std::to_string(track.times.size()) +
           " keys");
  }

  std::string node_name(std::size_t i) const
  {
    const std::string& name = m_gltf.nodes[i].name;
    return "node " + std::to_string(i) + (name.empty() ? "" : " (" + name + ")");
  }

  std::size_t checked(int index, std::size_t size, const std::string& name) const
  {
    if (index < 0 || std::size_t(index) >= size) fail(name + " " + std::to_string(index) + " is not there");
    return std::size_t(index);
  }

  [[noreturn]] void fail(const std::string& message) const { throw Input_error(m_file + ": " + message); }

  const tinygltf::Model& m_gltf;
  const std::string& m_file;
  Gltf_accessor_reader m_accessors;
  Keyframed_model m_model;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_geometries; // of mesh and primitive
  std::size_t m_without_triangles = 0;
};

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesIO

reads an animated model from a glTF 2.0 file, `.gltf` (with data inside or beside it) or `.glb`: the nodes, meshes,
skins and morph targets of its default scene, and all animations. Images are not looked at. Lists, strips and fans of
triangles are read, points and lines left out; accessors may be strided, sparse, or of normalised integers.

Needs tinygltf 2.6 or newer: whoever includes this header links with Debian's `libtinygltf` (CMake:
`TinyGLTF::TinyGLTF`), or defines `TINYGLTF_IMPLEMENTATION` in one of the program's files.

\throws Input_error if the file cannot be read, is no glTF 2.0, needs an extension that is not known here, or is not
consistent; the message names the node, primitive, vertex, accessor or channel.
*/
inline Keyframed_model read_gltf(const std::string& file)
{
  tinygltf::Model gltf;
  internal::parse_gltf(file, gltf);
  return internal::Gltf_model_builder(gltf, file)();
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_READ_GLTF_H
