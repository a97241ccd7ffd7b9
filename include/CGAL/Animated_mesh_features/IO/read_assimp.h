// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_READ_ASSIMP_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_READ_ASSIMP_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>
#include <CGAL/Animated_mesh_features/IO/internal/skin_influences.h>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

// Makes a Keyframed_model of what assimp has read.
class Assimp_model_builder
{
public:
  Assimp_model_builder(const aiScene& scene, const std::string& file)
    : m_scene(scene)
    , m_file(file)
  {}

  Keyframed_model operator()()
  {
    add_node(*m_scene.mRootNode, Keyframed_model::none);
    for (const auto& node : m_nodes) add_parts(*node.first, node.second);
    for (unsigned a = 0; a < m_scene.mNumAnimations; ++a) add_clip(*m_scene.mAnimations[a]);
    return std::move(m_model);
  }

private:
  static Eigen::Affine3d affine(const aiMatrix4x4& m)
  {
    Eigen::Affine3d a;
    for (unsigned row = 0; row < 4; ++row)
      for (unsigned column = 0; column < 4; ++column) a.matrix()(row, column) = double(m[row][column]);
    a.makeAffine();
    return a;
  }

  static Keyframed_model::Vector vector(const aiVector3D& v) { return {{double(v.x), double(v.y), double(v.z)}}; }

  void add_node(const aiNode& from, std::size_t parent)
  {
    const std::size_t index = m_model.nodes.size();
    Keyframed_model::Node node;
    node.name = from.mName.C_Str();
    node.parent = parent;
    node.matrix = affine(from.mTransformation);
    // what stays of it where a clip moves the node
    aiVector3D scale, translation;
    aiQuaternion rotation;
    from.mTransformation.Decompose(scale, rotation, translation);
    node.translation = vector(translation);
    node.rotation = {{double(rotation.x), double(rotation.y), double(rotation.z), double(rotation.w)}};
    node.scale = vector(scale);
    m_by_name.emplace(node.name, index);
    m_nodes.emplace_back(&from, index);
    m_model.nodes.push_back(std::move(node));
    for (unsigned c = 0; c < from.mNumChildren; ++c) add_node(*from.mChildren[c], index);
  }

  void add_parts(const aiNode& from, std::size_t node)
  {
    for (unsigned i = 0; i < from.mNumMeshes; ++i) {
      const aiMesh& mesh = *m_scene.mMeshes[from.mMeshes[i]];
      if ((mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) == 0) continue;
      Keyframed_model::Part part;
      part.node = node;
      part.mesh = mesh.mName.C_Str();
      part.primitive = i;
      part.name = "node \"" + m_model.nodes[node].name + "\", mesh " + std::to_string(from.mMeshes[i]);
      part.geometry = m_model.geometries.size();
      m_model.geometries.push_back(geometry(mesh, part.name));
      for (unsigned t = 0; t < mesh.mNumAnimMeshes; ++t) part.weights.push_back(double(mesh.mAnimMeshes[t]->mWeight));
      if (mesh.mNumBones > 0) {
        part.skin = m_model.skins.size();
        add_skin(mesh, node, part.name);
      }
      m_model.parts.push_back(std::move(part));
    }
  }

  Keyframed_model::Geometry geometry(const aiMesh& mesh, const std::string& name) const
  {
    Keyframed_model::Geometry g;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) g.points.push_back(vector(mesh.mVertices[v]));
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue; // points and lines; all else was cut into triangles
      for (unsigned k = 0; k < 3; ++k)
        if (face.mIndices[k] >= mesh.mNumVertices)
          fail(name + ": face " + std::to_string(f) + " has a corner that is not there");
      g.triangles.push_back({{face.mIndices[0], face.mIndices[1], face.mIndices[2]}});
    }
    for (unsigned t = 0; t < mesh.mNumAnimMeshes; ++t) {
      const aiAnimMesh& target = *mesh.mAnimMeshes[t];
      g.targets.emplace_back();
      if (!target.HasPositions()) continue;
      if (target.mNumVertices != mesh.mNumVertices) fail(name + ": a morph target has another number of vertices");
      for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const Keyframed_model::Vector to = vector(target.mVertices[v]), from = g.points[v];
        g.targets.back().push_back({{to[0] - from[0], to[1] - from[1], to[2] - from[2]}});
      }
    }
    if (mesh.mNumBones == 0) return g;
    std::vector<std::vector<Keyframed_model::Influence>> influences(mesh.mNumVertices);
    for (unsigned b = 0; b < mesh.mNumBones; ++b)
      for (unsigned i = 0; i < mesh.mBones[b]->mNumWeights; ++i) {
        const aiVertexWeight& w = mesh.mBones[b]->mWeights[i];
        if (w.mVertexId >= mesh.mNumVertices) fail(name + ": a bone moves a vertex that is not there");
        influences[w.mVertexId].push_back({b, double(w.mWeight)});
      }
    for (auto& of_vertex : influences) {
      double sum = 0;
      for (const Keyframed_model::Influence& i : of_vertex) sum += i.weight;
      if (!(sum > 0)) of_vertex = {{mesh.mNumBones, 1}}; // moves with the node, see add_skin()
      append_influences(std::move(of_vertex), g);
    }
    return g;
  }

  // The mesh's own node stands after the bones, for vertices that no bone moves.
  void add_skin(const aiMesh& mesh, std::size_t node, const std::string& name)
  {
    Keyframed_model::Skin skin;
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const auto joint = m_by_name.find(mesh.mBones[b]->mName.C_Str());
      if (joint == m_by_name.end()) fail(name + ": there is no node for the bone " + mesh.mBones[b]->mName.C_Str());
      skin.joints.push_back(joint->second);
      skin.inverse_binds.push_back(affine(mesh.mBones[b]->mOffsetMatrix));
    }
    skin.joints.push_back(node);
    skin.inverse_binds.push_back(Eigen::Affine3d::Identity());
    m_model.skins.push_back(std::move(skin));
  }

  void add_clip(const aiAnimation& from)
  {
    const double usual_ticks_per_second = 25; // assimp's own, where a format does not tell
    const double ticks = from.mTicksPerSecond > 0 ? from.mTicksPerSecond : usual_ticks_per_second;
    Keyframed_model::Clip clip;
    clip.name = from.mName.C_Str();
    for (unsigned c = 0; c < from.mNumChannels; ++c) add_channels(*from.mChannels[c], ticks, clip);
    for (unsigned c = 0; c < from.mNumMorphMeshChannels; ++c) add_weights(*from.mMorphMeshChannels[c], ticks, clip);
    if (from.mNumMeshChannels > 0)
      m_model.remarks.push_back("clip \"" + clip.name + "\": meshes that replace one another are left out");
    m_model.clips.push_back(std::move(clip));
  }

  void add_channels(const aiNodeAnim& from, double ticks, Keyframed_model::Clip& clip)
  {
    const auto node = m_by_name.find(from.mNodeName.C_Str());
    if (node == m_by_name.end()) {
      m_model.remarks.push_back("clip \"" + clip.name + "\" moves a node that is not there: " + from.mNodeName.C_Str());
      return;
    }
    typedef Keyframed_model::Path Path;
    const auto add = [&](Path path, unsigned keys, const auto* key, const auto& append) {
      if (keys == 0) return;
      Keyframed_model::Channel channel;
      channel.node = node->second;
      channel.path = path;
      channel.track.is_rotation = path == Path::ROTATION;
      channel.track.width = path == Path::ROTATION ? 4 : 3;
      for (unsigned k = 0; k < keys; ++k) {
        channel.track.times.push_back(key[k].mTime / ticks);
        append(key[k].mValue, channel.track.values);
      }
      clip.channels.push_back(std::move(channel));
    };
    const auto append_vector = [](const aiVector3D& v, std::vector<double>& to) {
      to.insert(to.end(), {double(v.x), double(v.y), double(v.z)});
    };
    const auto append_rotation = [](const aiQuaternion& q, std::vector<double>& to) {
      to.insert(to.end(), {double(q.x), double(q.y), double(q.z), double(q.w)});
    };
    add(Path::TRANSLATION, from.mNumPositionKeys, from.mPositionKeys, append_vector);
    add(Path::ROTATION, from.mNumRotationKeys, from.mRotationKeys, append_rotation);
    add(Path::SCALE, from.mNumScalingKeys, from.mScalingKeys, append_vector);
  }

  // The name is that of a node or of a mesh, for some formats with a number after it.
  void add_weights(const aiMeshMorphAnim& from, double ticks, Keyframed_model::Clip& clip)
  {
    std::string name = from.mName.C_Str();
    name = name.substr(0, name.find('*'));
    bool is_found = false;
    for (const Keyframed_model::Part& part : m_model.parts) {
      if (part.weights.empty() ||
          (m_model.nodes[part.node].name != name && part.mesh.substr(0, part.mesh.find('*')) != name))
        continue;
      is_found = true;
      Keyframed_model::Channel channel;
      channel.node = part.node;
      channel.path = Keyframed_model::Path::WEIGHTS;
      channel.track.width = part.weights.size();
      for (unsigned k = 0; k < from.mNumKeys; ++k) {
        const aiMeshMorphKey& key = from.mKeys[k];
        std::vector<double> weights(part.weights.size(), 0);
        for (unsigned i = 0; i < key.mNumValuesAndWeights; ++i)
          if (key.mValues[i] < weights.size()) weights[key.mValues[i]] = key.mWeights[i];
        channel.track.times.push_back(key.mTime / ticks);
        channel.track.values.insert(channel.track.values.end(), weights.begin(), weights.end());
      }
      clip.channels.push_back(std::move(channel));
    }
    if (!is_found)
      m_model.remarks.push_back("clip \"" + clip.name + "\" morphs a mesh that is not there: " + from.mName.C_Str());
  }

  [[noreturn]] void fail(const std::string& message) const { throw Input_error(m_file + ": " + message); }

  const aiScene& m_scene;
  const std::string& m_file;
  Keyframed_model m_model;
  std::vector<std::pair<const aiNode*, std::size_t>> m_nodes;
  std::map<std::string, std::size_t> m_by_name;
};

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesModels

reads an animated model through assimp: FBX, Collada, X and many more. Best effort: what assimp makes of the file is
what is read, and between keys everything is interpolated linearly. Faces are cut into triangles.

Not for glTF, for which `read_gltf()` is exact: assimp 5.2 takes the tangents of splines for keys or drops them.

Whoever includes this header links with assimp 5 (CMake: `assimp::assimp`).

\throws Input_error if assimp cannot read the file, or refers to something that is not there.
*/
inline Keyframed_model read_assimp(const std::string& file)
{
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(file, aiProcess_Triangulate);
  if (scene == nullptr) throw Input_error(file + ": cannot be read through assimp: " + importer.GetErrorString());
  if (scene->mRootNode == nullptr) throw Input_error(file + ": holds no scene");
  return internal::Assimp_model_builder(*scene, file)();
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_READ_ASSIMP_H
