// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_JOINT_ANGLES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_JOINT_ANGLES_H

#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesModels

A joint of a model's skeleton in the course of a clip.
*/
struct Joint_angles
{
  std::string name;           ///< of its node
  std::vector<double> angles; ///< at each time, of its rotation against its parent relative to rest (degrees, 0 to 180)
  std::vector<std::size_t> region; ///< vertices of the file that both sides of the joint move, ascending
};

namespace internal {

inline Eigen::Quaterniond rest_rotation(const Keyframed_model::Node& node)
{
  if (node.matrix) return Eigen::Quaterniond(node.matrix->rotation());
  return Eigen::Quaterniond(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]).normalized();
}

// Of the rotations of a node at all times; zeros if the clip does not turn it.
inline std::vector<double> angles_against_rest(const Keyframed_model& model, const Keyframed_model::Clip& clip,
                                               std::size_t node, const std::vector<double>& times)
{
  const double degrees = 180 / 3.14159265358979323846;
  const Eigen::Quaterniond rest = rest_rotation(model.nodes[node]);
  std::vector<double> angles(times.size(), 0.);
  for (const Keyframed_model::Channel& channel : clip.channels) {
    if (channel.node != node || channel.path != Keyframed_model::Path::ROTATION) continue;
    for (std::size_t i = 0; i < times.size(); ++i) {
      double q[4];
      channel.track.evaluate(times[i], q);
      const Eigen::Quaterniond turn = rest.conjugate() * Eigen::Quaterniond(q[3], q[0], q[1], q[2]);
      angles[i] = 2 * std::atan2(turn.vec().norm(), std::abs(turn.w())) * degrees;
    }
  }
  return angles;
}

// Of all vertices of a part, to each node the sum of the weights of its joints and of what hangs on them; `visit(vertex,
// node, weight)` is called once for a vertex and a node that moves it.
template <class Visit>
void for_each_subtree_weight(const Keyframed_model& model, const Keyframed_model::Part& part, const Visit& visit)
{
  const Keyframed_model::Geometry& geometry = model.geometries[part.geometry];
  const Keyframed_model::Skin& skin = model.skins[part.skin];
  std::vector<double> weights(model.nodes.size(), 0.);
  std::vector<std::size_t> touched;
  for (std::size_t v = 0; v < geometry.points.size(); ++v) {
    touched.clear();
    for (std::size_t i = geometry.first_influence[v]; i < geometry.first_influence[v + 1]; ++i)
      for (std::size_t node = skin.joints[geometry.influences[i].joint]; node != Keyframed_model::none;
           node = model.nodes[node].parent) {
        if (weights[node] == 0) touched.push_back(node);
        weights[node] += geometry.influences[i].weight;
      }
    for (std::size_t node : touched) {
      visit(v, node, weights[node]);
      weights[node] = 0;
    }
  }
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesModels

tells how the joints of a model's skeletons are bent in a clip, and which vertices are where they bend: those whose weights
on the joint and on what hangs on it sum to more than 0.1 and less than 0.9. Nodes that are no joints are left out.

\param model a model that a `Keyframed_model_evaluator` has accepted for this clip.
\param clip of the model.
\param times at which angles are asked for (s), as `frame_times()` makes them.
\returns the joints, in the order of the nodes.

Linear in the number of influences, times the depth of the skeleton, and in that of joints and times.
*/
inline std::vector<Joint_angles> joint_angles(const Keyframed_model& model, const Keyframed_model::Clip& clip,
                                              const std::vector<double>& times)
{
  const double least = 0.1, most = 0.9;
  std::vector<char> is_joint(model.nodes.size(), 0);
  std::vector<std::vector<std::size_t>> regions(model.nodes.size());
  std::size_t first = 0;
  for (const Keyframed_model::Part& part : model.parts) {
    if (part.skin != Keyframed_model::none) {
      for (std::size_t node : model.skins[part.skin].joints) is_joint[node] = 1;
      internal::for_each_subtree_weight(model, part, [&](std::size_t v, std::size_t node, double weight) {
        if (weight > least && weight < most) regions[node].push_back(first + v);
      });
    }
    first += model.geometries[part.geometry].points.size();
  }
  std::vector<Joint_angles> joints;
  for (std::size_t node = 0; node < model.nodes.size(); ++node)
    if (is_joint[node])
      joints.push_back(
          {model.nodes[node].name, internal::angles_against_rest(model, clip, node, times), regions[node]});
  return joints;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_JOINT_ANGLES_H
