// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_KEYFRAMED_MODEL_EVALUATOR_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_KEYFRAMED_MODEL_EVALUATOR_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesModels

Tells where the vertices of a `Keyframed_model` are at a time of one of its clips, in the coordinates of the scene.

Vertices are displaced by their morph targets, \f$p + \sum_t w_t d_t\f$; then, with a skin, moved by its joints,
\f$\sum_j w_j\, G_j B_j\, p\f$, where \f$G\f$ takes a node's coordinates to those of the scene and \f$B\f$ is the
inverse bind matrix; else moved by \f$G\f$ of their node. In double precision; vertices of equal data get equal bits.

The model is kept by reference. An evaluator may be used by several threads at once.
*/
class Keyframed_model_evaluator
{
public:
  /// the positions of all vertices, those of each part after those of the one before.
  typedef std::vector<std::array<double, 3>> Points;

  /// checks a model and makes its tree of nodes ready to be evaluated.
  /// \param model is kept by reference.
  /// \param clip the index of the clip that is played.
  /// \param name what the model is called in messages: its file.
  /// \throw Input_error if nodes are their own ancestors, something refers to what is not there, a channel has not the
  /// values that its keys ask for, or a geometry is attached to nothing.
  Keyframed_model_evaluator(const Keyframed_model& model, std::size_t clip, const std::string& name)
    : Keyframed_model_evaluator(model, model.clips.at(clip), name)
  {}

  /// the same for a clip that need not be one of the model's, also kept by reference.
  Keyframed_model_evaluator(const Keyframed_model& model, const Keyframed_model::Clip& clip, const std::string& name)
    : m_model(&model)
    , m_clip(&clip)
    , m_name(name)
  {
    order_nodes();
    for (const Keyframed_model::Part& part : model.parts) check(part);
    m_is_moved.assign(model.nodes.size(), 0);
    for (const Keyframed_model::Channel& channel : m_clip->channels) check(channel);
  }

  /// writes the positions at `time` (s). Linear in the number of nodes, targets and influences.
  void operator()(double time, Points& points) const
  {
    const State state = state_at(time);
    points.resize(m_model->number_of_vertices());
    std::size_t first = 0;
    for (std::size_t i = 0; i < m_model->parts.size(); ++i) {
      const Keyframed_model::Part& part = m_model->parts[i];
      std::array<double, 3>* const p = points.data() + first;
      morph(m_model->geometries[part.geometry], state.weights[i], p);
      if (part.skin == Keyframed_model::none)
        transform(state.global[part.node], m_model->geometries[part.geometry].points.size(), p);
      else
        skin(part, state, p);
      first += m_model->geometries[part.geometry].points.size();
    }
  }

  /// whether a part is turned inside out at `time`: its node mirrors, so that triangles run the other way round.
  std::vector<char> mirrored_parts(double time) const
  {
    const State state = state_at(time);
    std::vector<char> mirrored;
    for (const Keyframed_model::Part& part : m_model->parts)
      mirrored.push_back(state.global[part.node].linear().determinant() < 0);
    return mirrored;
  }

private:
  typedef std::vector<Eigen::Affine3d> Transformations;

  // Everything that depends on the time.
  struct State
  {
    Transformations global;
    std::vector<std::vector<double>> weights; // of each part
  };

  State state_at(double time) const
  {
    State state;
    std::vector<Keyframed_model::Node> nodes(m_model->nodes);
    for (const Keyframed_model::Part& part : m_model->parts) state.weights.push_back(part.weights);
    for (const Keyframed_model::Channel& channel : m_clip->channels) {
      Keyframed_model::Node& node = nodes[channel.node];
      switch (channel.path) {
      case Keyframed_model::Path::TRANSLATION:
        channel.track.evaluate(time, node.translation.data());
        break;
      case Keyframed_model::Path::ROTATION:
        channel.track.evaluate(time, node.rotation.data());
        break;
      case Keyframed_model::Path::SCALE:
        channel.track.evaluate(time, node.scale.data());
        break;
      case Keyframed_model::Path::WEIGHTS:
        for (std::size_t i = 0; i < m_model->parts.size(); ++i)
          if (m_model->parts[i].node == channel.node) channel.track.evaluate(time, state.weights[i].data());
        break;
      }
    }
    state.global.resize(nodes.size());
    for (std::size_t i : m_parents_first) {
      const Eigen::Affine3d local = m_is_moved[i] || !nodes[i].matrix ? transformation(nodes[i]) : *nodes[i].matrix;
      state.global[i] = nodes[i].parent == Keyframed_model::none ? local : state.global[nodes[i].parent] * local;
    }
    return state;
  }

  static Eigen::Affine3d transformation(const Keyframed_model::Node& node)
  {
    const Eigen::Map<const Eigen::Vector3d> t(node.translation.data()), s(node.scale.data());
    const Eigen::Quaterniond q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    return Eigen::Translation3d(t) * q.normalized() * Eigen::Scaling(Eigen::Vector3d(s));
  }

  static void morph(const Keyframed_model::Geometry& geometry, const std::vector<double>& weights,
                    std::array<double, 3>* points)
  {
    std::copy(geometry.points.begin(), geometry.points.end(), points);
    for (std::size_t t = 0; t < weights.size(); ++t) {
      if (weights[t] == 0) continue;
      const std::vector<Keyframed_model::Vector>& target = geometry.targets[t];
      for (std::size_t v = 0; v < target.size(); ++v)
        for (int k = 0; k < 3; ++k) points[v][k] += weights[t] * target[v][k];
    }
  }

  static void transform(const Eigen::Affine3d& by, std::size_t n, std::array<double, 3>* points)
  {
    for (std::size_t v = 0; v < n; ++v) {
      Eigen::Map<Eigen::Vector3d> p(points[v].data());
      p = (by * Eigen::Vector3d(p)).eval();
    }
  }

  void skin(const Keyframed_model::Part& part, const State& state, std::array<double, 3>* points) const
  {
    const Keyframed_model::Geometry& geometry = m_model->geometries[part.geometry];
    const Keyframed_model::Skin& skin = m_model->skins[part.skin];
    Transformations joints;
    for (std::size_t j = 0; j < skin.joints.size(); ++j)
      joints.push_back(state.global[skin.joints[j]] * skin.inverse_binds[j]);
    for (std::size_t v = 0; v < geometry.points.size(); ++v) {
      Eigen::Map<Eigen::Vector3d> p(points[v].data());
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t i = geometry.first_influence[v]; i < geometry.first_influence[v + 1]; ++i)
        sum += geometry.influences[i].weight * (joints[geometry.influences[i].joint] * Eigen::Vector3d(p));
      p = sum;
    }
  }

  void order_nodes()
  {
    const std::vector<Keyframed_model::Node>& nodes = m_model->nodes;
    std::vector<char> is_ordered(nodes.size(), 0);
    std::vector<std::size_t> ancestors;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      ancestors.clear();
      for (std::size_t j = i; j != Keyframed_model::none && !is_ordered[j]; j = nodes[j].parent) {
        if (ancestors.size() > nodes.size()) fail("node " + std::to_string(i) + " is among its own ancestors");
        if (nodes[j].parent != Keyframed_model::none && nodes[j].parent >= nodes.size())
          fail("node " + std::to_string(j) + " has a parent that is not there");
        ancestors.push_back(j);
      }
      for (; !ancestors.empty(); ancestors.pop_back()) {
        m_parents_first.push_back(ancestors.back());
        is_ordered[ancestors.back()] = 1;
      }
    }
  }

  void check(const Keyframed_model::Part& part) const
  {
    const Keyframed_model& m = *m_model;
    if (part.geometry >= m.geometries.size() || part.node >= m.nodes.size())
      fail(part.name + " refers to a geometry or node that is not there");
    const Keyframed_model::Geometry& g = m.geometries[part.geometry];
    if (part.weights.size() != g.targets.size())
      fail(part.name + " has " + std::to_string(part.weights.size()) + " weights for " +
           std::to_string(g.targets.size()) + " morph targets");
    for (const auto& target : g.targets)
      if (!target.empty() && target.size() != g.points.size())
        fail(part.name + " has a morph target of another number of vertices");
    if (part.skin == Keyframed_model::none) return;
    if (part.skin >= m.skins.size()) fail(part.name + " refers to a skin that is not there");
    const Keyframed_model::Skin& s = m.skins[part.skin];
    if (g.first_influence.size() != g.points.size() + 1 || s.inverse_binds.size() != s.joints.size())
      fail(part.name + " has a skin, but not what it takes");
    for (std::size_t j : s.joints)
      if (j >= m.nodes.size()) fail(part.name + ": its skin has a joint that is not there");
    for (const Keyframed_model::Influence& i : g.influences)
      if (i.joint >= s.joints.size())
        fail(part.name + ": a vertex moves with joint " + std::to_string(i.joint) + ", its skin has " +
             std::to_string(s.joints.size()));
  }

  void check(const Keyframed_model::Channel& channel)
  {
    const std::string name = "clip \"" + m_clip->name + "\", ";
    if (channel.node >= m_model->nodes.size()) fail(name + "a channel moves a node that is not there");
    const std::string node = "node " + std::to_string(channel.node) + " (" + m_model->nodes[channel.node].name + ")";
    const Keyframe_track& track = channel.track;
    if (!track.is_complete()) fail(name + node + ": the times of the keys do not ascend, or values are missing");
    std::size_t width = channel.path == Keyframed_model::Path::ROTATION ? 4 : 3;
    if (channel.path == Keyframed_model::Path::WEIGHTS) {
      width = track.width;
      for (const Keyframed_model::Part& part : m_model->parts)
        if (part.node == channel.node && part.weights.size() != track.width)
          fail(name + node + ": " + std::to_string(track.width) + " weights at a key, but " + part.name + " has " +
               std::to_string(part.weights.size()) + " morph targets");
    } else {
      m_is_moved[channel.node] = 1;
    }
    if (track.width != width || track.is_rotation != (channel.path == Keyframed_model::Path::ROTATION))
      fail(name + node + ": a channel has values of another kind than it moves");
  }

  [[noreturn]] void fail(const std::string& message) const { throw Input_error(m_name + ": " + message); }

  const Keyframed_model* m_model;
  const Keyframed_model::Clip* m_clip;
  std::string m_name;
  std::vector<std::size_t> m_parents_first;
  std::vector<char> m_is_moved; // whether the clip moves a node
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_KEYFRAMED_MODEL_EVALUATOR_H
