// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_MODEL_BUILDER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_MODEL_BUILDER_H

#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_accessor_reader.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_check.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_clip_reader.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_geometry_reader.h>
#include <CGAL/Animated_mesh_features/IO/internal/parse_gltf.h>

#include <tiny_gltf.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Makes a Keyframed_model of what tinygltf has parsed.
class Gltf_model_builder
{
public:
  Gltf_model_builder(const tinygltf::Model& gltf, const std::string& file)
    : m_gltf(gltf)
    , m_check(file)
    , m_accessors(gltf, m_check)
  {}

  Keyframed_model operator()()
  {
    for (const tinygltf::Node& node : m_gltf.nodes) add_node(node);
    connect_nodes();
    for (std::size_t i = 0; i < m_gltf.skins.size(); ++i) add_skin(i);
    add_scene();
    const Gltf_clip_reader clips(m_gltf, m_accessors, m_check);
    for (std::size_t i = 0; i < m_gltf.animations.size(); ++i) m_model.clips.push_back(clips.read(i));
    if (m_without_triangles > 0)
      m_model.remarks.push_back(std::to_string(m_without_triangles) +
                                " of the meshes' primitives left out: points or lines");
    if (m_features > 0)
      m_model.remarks.push_back(std::to_string(m_features) +
                                (m_features == 1 ? " sphere left out: a feature" : " spheres left out: features") +
                                " that detect_features --glb has put there");
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
    if (from.size() != n)
      m_check.fail(name + " has " + std::to_string(from.size()) + " numbers, not " + std::to_string(n));
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
        Keyframed_model::Node& node =
            m_model.nodes[m_check.index(child, m_model.nodes.size(), node_name(i) + ": child")];
        if (node.parent != none) m_check.fail(node_name(std::size_t(child)) + " has two parents");
        node.parent = i;
      }
  }

  void add_skin(std::size_t i)
  {
    const tinygltf::Skin& from = m_gltf.skins[i];
    const std::string name = "skin " + std::to_string(i);
    Keyframed_model::Skin skin;
    for (int joint : from.joints) skin.joints.push_back(m_check.index(joint, m_model.nodes.size(), name + ": joint"));
    skin.inverse_binds.assign(skin.joints.size(), Eigen::Affine3d::Identity());
    if (from.inverseBindMatrices >= 0) {
      const std::vector<double> matrices = m_accessors.read(from.inverseBindMatrices, 16, name);
      if (matrices.size() < 16 * skin.joints.size())
        m_check.fail(name + " has fewer inverse bind matrices than joints");
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
      for (int root : m_gltf.scenes[m_check.index(scene, m_gltf.scenes.size(), "default scene")].nodes)
        waiting.push_back(m_check.index(root, m_gltf.nodes.size(), "node of a scene"));
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
    for (std::size_t i = 0; i < m_gltf.nodes.size(); ++i) {
      if (!is_drawn[i] || m_gltf.nodes[i].mesh < 0) continue;
      if (is_feature(m_gltf.nodes[i]))
        ++m_features;
      else
        add_parts(i);
    }
  }

  // Scenes of detect_features --glb have a sphere for each feature, with its numbers: no part of the body.
  static bool is_feature(const tinygltf::Node& node)
  {
    const auto has = [&](const char* name) { return node.extras.Has(name); };
    return node.extras.IsObject() && has("sigma") && has("tau") && has("strength") && has("at_scale_limit");
  }

  void add_parts(std::size_t n)
  {
    const tinygltf::Node& node = m_gltf.nodes[n];
    const std::size_t mesh_index = m_check.index(node.mesh, m_gltf.meshes.size(), node_name(n) + ": mesh");
    const tinygltf::Mesh& mesh = m_gltf.meshes[mesh_index];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const std::string name =
          node_name(n) + ", mesh " + std::to_string(mesh_index) + ", primitive " + std::to_string(p);
      const auto known = m_geometries.find({mesh_index, p});
      const std::size_t geometry = known != m_geometries.end() ? known->second : add_geometry(mesh.primitives[p], name);
      m_geometries[{mesh_index, p}] = geometry;
      if (geometry == none) continue;
      m_accessors.account(3 * m_model.geometries[geometry].points.size(), name);
      Keyframed_model::Part part;
      part.geometry = geometry;
      part.node = n;
      part.name = name;
      part.mesh = mesh.name;
      part.primitive = p;
      if (node.skin >= 0 && !m_model.geometries[geometry].first_influence.empty())
        part.skin = m_check.index(node.skin, m_model.skins.size(), name + ": skin");
      part.weights = !node.weights.empty() ? node.weights : mesh.weights;
      if (part.weights.empty()) part.weights.assign(m_model.geometries[geometry].targets.size(), 0);
      m_model.parts.push_back(std::move(part));
    }
  }

  std::size_t add_geometry(const tinygltf::Primitive& primitive, const std::string& name)
  {
    std::optional<Keyframed_model::Geometry> geometry =
        Gltf_geometry_reader(m_accessors, m_check).read(primitive, name);
    if (!geometry) {
      ++m_without_triangles;
      return none;
    }
    m_model.geometries.push_back(std::move(*geometry));
    return m_model.geometries.size() - 1;
  }

  std::string node_name(std::size_t i) const
  {
    const std::string& name = m_gltf.nodes[i].name;
    return "node " + std::to_string(i) + (name.empty() ? "" : " (" + name + ")");
  }

  const tinygltf::Model& m_gltf;
  const Gltf_check m_check;
  const Gltf_accessor_reader m_accessors;
  Keyframed_model m_model;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_geometries; // of mesh and primitive
  std::size_t m_without_triangles = 0;
  std::size_t m_features = 0;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_MODEL_BUILDER_H
