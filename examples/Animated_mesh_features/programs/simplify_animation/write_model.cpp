// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "simplify_animation/write_model.h"

#include "scenes/Gltf_buffer.h"
#include "scenes/append_little_endian.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
namespace IO = CGAL::Animated_mesh_features::IO;

namespace Simplify_animation {

namespace {

typedef IO::Keyframed_model Model;
typedef nlohmann::ordered_json Json;

// One skin for all parts: a joint for each node and inverse bind matrix. A part without a skin is moved by its node,
// as by a joint whose matrix is the identity.
class Joined_skin
{
public:
  Joined_skin(const Model& model, const std::string& name)
    : m_model(&model)
  {
    const Eigen::Affine3d identity = Eigen::Affine3d::Identity();
    for (const Model::Part& part : model.parts) {
      const Model::Geometry& geometry = model.geometries[part.geometry];
      if (!geometry.targets.empty())
        throw AMF::Input_error(name + ": " + part.name + " has " + std::to_string(geometry.targets.size()) +
                               (geometry.targets.size() == 1 ? " morph target" : " morph targets") +
                               ", which a simplified model would lose; --format obj keeps what they move");
      std::vector<std::size_t> joints;
      if (part.skin == Model::none) {
        joints.push_back(joint(part.node, identity));
      } else {
        const Model::Skin& skin = model.skins[part.skin];
        for (std::size_t j = 0; j < skin.joints.size(); ++j)
          joints.push_back(joint(skin.joints[j], skin.inverse_binds[j]));
      }
      m_joints.push_back(joints);
      // parts that a joint moves alike have the same coordinates
      std::size_t space = m_spaces.size();
      for (std::size_t p = 0; p < m_spaces.size() && space == m_spaces.size(); ++p)
        for (std::size_t j : joints)
          if (std::find(m_joints[p].begin(), m_joints[p].end(), j) != m_joints[p].end()) space = m_spaces[p];
      m_spaces.push_back(space);
      m_first.push_back(m_first.empty() ? 0 : m_first.back() + m_last_size);
      m_last_size = geometry.points.size();
    }
    if (m_nodes.size() > 65535)
      throw AMF::Input_error(name + ": has " + std::to_string(m_nodes.size()) + " joints, glTF has numbers for 65535");
  }

  const std::vector<std::size_t>& nodes() const { return m_nodes; }
  const std::vector<Eigen::Affine3d>& inverse_binds() const { return m_inverse_binds; }

  struct Vertex
  {
    std::size_t space;
    Model::Vector point;
    std::vector<std::pair<std::size_t, double>> influences; // joint, weight
  };

  // of the file, counted through all parts
  Vertex vertex(std::size_t v) const
  {
    std::size_t p = m_first.size() - 1;
    while (m_first[p] > v) --p;
    const Model::Part& part = m_model->parts[p];
    const Model::Geometry& geometry = m_model->geometries[part.geometry];
    const std::size_t i = v - m_first[p];
    Vertex result = {m_spaces[p], geometry.points[i], {}};
    if (part.skin == Model::none || geometry.first_influence.empty())
      result.influences.emplace_back(m_joints[p].front(), 1.);
    else
      for (std::size_t k = geometry.first_influence[i]; k < geometry.first_influence[i + 1]; ++k)
        result.influences.emplace_back(m_joints[p][geometry.influences[k].joint], geometry.influences[k].weight);
    return result;
  }

private:
  std::size_t joint(std::size_t node, const Eigen::Affine3d& inverse_bind)
  {
    for (std::size_t j = 0; j < m_nodes.size(); ++j)
      if (m_nodes[j] == node && m_inverse_binds[j].matrix() == inverse_bind.matrix()) return j;
    m_nodes.push_back(node);
    m_inverse_binds.push_back(inverse_bind);
    return m_nodes.size() - 1;
  }

  const Model* m_model;
  std::vector<std::size_t> m_nodes;
  std::vector<Eigen::Affine3d> m_inverse_binds;
  std::vector<std::vector<std::size_t>> m_joints; // of each part
  std::vector<std::size_t> m_spaces, m_first;     // of each part
  std::size_t m_last_size = 0;
};

// The vertices of a level, in the form of glTF.
struct Skinned_vertices
{
  std::vector<float> points, weights;
  std::vector<std::uint16_t> joints;

  Skinned_vertices(const Joined_skin& skin, const IO::Vertex_origins& origins, const AMF::Animation_level& level,
                   const std::vector<std::size_t>& drawn, const std::string& name)
  {
    for (std::size_t v : drawn) {
      Model::Vector point = {{0, 0, 0}};
      std::map<std::size_t, double> sums;
      const auto row = level.binding.vertices(v);
      std::size_t space = 0;
      for (std::size_t i = 0; i < std::size_t(row.size()); ++i) {
        const double w = level.binding.weights(v)[std::ptrdiff_t(i)];
        const Joined_skin::Vertex fine = skin.vertex(origins.of(row[std::ptrdiff_t(i)]).front());
        if (i == 0) space = fine.space;
        if (fine.space != space)
          throw AMF::Input_error(name + ": a vertex follows parts of the model whose coordinates differ; it cannot be "
                                        "written as GLB, --format obj can");
        for (std::size_t k = 0; k < 3; ++k) point[k] += w * fine.point[k];
        for (const auto& influence : fine.influences) sums[influence.first] += w * influence.second;
      }
      add(point, sums);
    }
  }

private:
  // the four largest weights, which sum to 1
  void add(const Model::Vector& point, const std::map<std::size_t, double>& sums)
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (const auto& s : sums)
      if (s.second > 0) order.emplace_back(-s.second, s.first);
    std::sort(order.begin(), order.end());
    order.resize((std::min)(order.size(), std::size_t(4)));
    double sum = 0;
    for (const auto& o : order) sum -= o.first;
    for (std::size_t k = 0; k < 4; ++k) {
      weights.push_back(k < order.size() ? float(-order[k].first / sum) : 0.f);
      joints.push_back(k < order.size() ? std::uint16_t(order[k].second) : std::uint16_t(0));
    }
    for (double x : point) points.push_back(float(x));
  }
};

Model_texture::Corners without_texture(const AMF::Animation_level& level)
{
  Model_texture::Corners corners;
  for (std::size_t v = 0; v < level.binding.size(); ++v) corners.vertices.push_back(v);
  for (const AMF::Rest_shape::Triangle& t : level.triangles) corners.triangles.push_back({{t[0], t[1], t[2]}});
  return corners;
}

std::vector<float> floats(const std::vector<double>& values)
{
  return std::vector<float>(values.begin(), values.end());
}

Json node_json(const Model& model, std::size_t i)
{
  const Model::Node& node = model.nodes[i];
  Json json = Json::object();
  if (!node.name.empty()) json["name"] = node.name;
  Json children = Json::array();
  for (std::size_t c = 0; c < model.nodes.size(); ++c)
    if (model.nodes[c].parent == i) children.push_back(c);
  if (!children.empty()) json["children"] = children;
  const bool is_moved = std::any_of(model.clips.begin(), model.clips.end(), [&](const Model::Clip& clip) {
    return std::any_of(clip.channels.begin(), clip.channels.end(),
                       [&](const Model::Channel& c) { return c.node == i; });
  });
  if (node.matrix && !is_moved) {
    json["matrix"] = std::vector<double>(node.matrix->matrix().data(), node.matrix->matrix().data() + 16);
    return json;
  }
  json["translation"] = node.translation;
  json["rotation"] = node.rotation;
  json["scale"] = node.scale;
  return json;
}

Json clip_json(const Model::Clip& clip, Programs::Gltf_buffer& buffer)
{
  Json json = {{"name", clip.name}, {"samplers", Json::array()}, {"channels", Json::array()}};
  std::map<std::vector<double>, std::size_t> inputs; // channels share their times, as a rule
  for (const Model::Channel& channel : clip.channels) {
    if (channel.path == Model::Path::WEIGHTS) continue;
    const IO::Keyframe_track& track = channel.track;
    const char* const interpolation = track.interpolation == IO::Keyframe_track::Interpolation::STEP ? "STEP"
                                      : track.interpolation == IO::Keyframe_track::Interpolation::LINEAR
                                          ? "LINEAR"
                                          : "CUBICSPLINE";
    const char* const path = channel.path == Model::Path::TRANSLATION ? "translation"
                             : channel.path == Model::Path::ROTATION  ? "rotation"
                                                                      : "scale";
    const auto found = inputs.find(track.times);
    const std::size_t input = found != inputs.end() ? found->second : buffer.add_with_bounds(floats(track.times), 1);
    inputs.emplace(track.times, input);
    const std::size_t output = buffer.add(floats(track.values), track.width);
    json["channels"].push_back(
        {{"sampler", json["samplers"].size()}, {"target", {{"node", channel.node}, {"path", path}}}});
    json["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
  }
  return json;
}

void put(std::ostream& os, std::size_t number)
{
  std::string bytes;
  Programs::append_little_endian(bytes, std::vector<std::uint32_t>{static_cast<std::uint32_t>(number)});
  os << bytes;
}

} // namespace

void write_model(std::ostream& os, const Model& model, const IO::Vertex_origins& origins,
                 const AMF::Animation_level& level, const Model_texture* texture, const std::string& name)
{
  const Joined_skin skin(model, name);
  const Model_texture::Corners drawn = texture != nullptr ? texture->corners(level) : without_texture(level);
  const Skinned_vertices vertices(skin, origins, level, drawn.vertices, name);
  Programs::Gltf_buffer buffer;
  Json gltf = {{"asset", {{"version", "2.0"}, {"generator", "simplify_animation"}}}, {"scene", 0}};
  buffer.begin_view(Programs::Gltf_buffer::VERTICES);
  Json attributes = {{"POSITION", buffer.add_with_bounds(vertices.points, 3)}};
  buffer.begin_view(Programs::Gltf_buffer::VERTICES);
  attributes["JOINTS_0"] = buffer.add(vertices.joints, 4);
  buffer.begin_view(Programs::Gltf_buffer::VERTICES);
  attributes["WEIGHTS_0"] = buffer.add(vertices.weights, 4);
  if (!drawn.places.empty()) {
    std::vector<float> places;
    for (const Model_texture::Place& p : drawn.places) places.insert(places.end(), {float(p[0]), float(p[1])});
    buffer.begin_view(Programs::Gltf_buffer::VERTICES);
    attributes["TEXCOORD_0"] = buffer.add(places, 2);
  }
  std::vector<std::uint32_t> corners;
  for (const std::array<std::size_t, 3>& t : drawn.triangles)
    for (std::size_t v : t) corners.push_back(std::uint32_t(v));
  buffer.begin_view(Programs::Gltf_buffer::TRIANGLES);
  const std::size_t indices = buffer.add(corners, 1);
  buffer.begin_view(Programs::Gltf_buffer::ANIMATION);
  std::vector<float> binds;
  for (const Eigen::Affine3d& m : skin.inverse_binds())
    binds.insert(binds.end(), m.matrix().data(), m.matrix().data() + 16);
  const std::size_t inverse_binds = buffer.add(binds, 16);

  Json roots = Json::array(), nodes = Json::array();
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    nodes.push_back(node_json(model, i));
    if (model.nodes[i].parent == Model::none) roots.push_back(i);
  }
  roots.push_back(nodes.size());
  nodes.push_back({{"name", "simplified"}, {"mesh", 0}, {"skin", 0}});
  gltf["scenes"] = Json::array({{{"nodes", roots}}});
  gltf["nodes"] = nodes;
  gltf["meshes"] = Json::array(
      {{{"primitives", Json::array({{{"attributes", attributes}, {"indices", indices}}})}, {"name", "simplified"}}});
  gltf["skins"] = Json::array({{{"joints", skin.nodes()}, {"inverseBindMatrices", inverse_binds}}});
  Json animations = Json::array();
  for (const Model::Clip& clip : model.clips) {
    const Json json = clip_json(clip, buffer);
    if (!json["channels"].empty()) animations.push_back(json);
  }
  if (!animations.empty()) gltf["animations"] = animations;
  buffer.append_to(gltf);

  std::string text = gltf.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.append((4 - text.size() % 4) % 4, ' ');
  os << "glTF";
  put(os, 2);
  put(os, 12 + 8 + 8 + text.size() + buffer.size());
  put(os, text.size());
  os << "JSON" << text;
  put(os, buffer.size());
  os.write("BIN\0", 4);
  os << buffer.data();
}

} // namespace Simplify_animation
