// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_KEYFRAMED_MODEL_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_KEYFRAMED_MODEL_H

#include <CGAL/Animated_mesh_features/IO/Keyframe_track.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesIO

What files of animated models hold, whatever their format: a tree of nodes with a transformation each, triangle meshes
that are attached to nodes or to skeletons of nodes and have morph targets, and clips, which change transformations and
weights with time. Readers of formats fill it; `Keyframed_model_evaluator` tells where the vertices are at a time.

Whatever refers to something else does so by its index. The semantics are those of glTF 2.0.
*/
struct Keyframed_model
{
  /// stands for no index.
  static constexpr std::size_t none = std::size_t(-1);

  typedef std::array<double, 3> Vector;

  /// A node's transformation, relative to its parent, is its `matrix` if it has one and no clip moves it; else a scale,
  /// followed by a rotation (x, y, z, w), followed by a translation.
  struct Node
  {
    std::string name;
    std::size_t parent = none;
    std::optional<Eigen::Affine3d> matrix;
    Vector translation = {{0, 0, 0}};
    std::array<double, 4> rotation = {{0, 0, 0, 1}};
    Vector scale = {{1, 1, 1}};
  };

  /// A vertex moves with the node `joint` of its skin with this weight.
  struct Influence
  {
    std::size_t joint;
    double weight;
  };

  struct Geometry
  {
    std::vector<Vector> points;
    std::vector<std::array<std::size_t, 3>> triangles;

    /// for each morph target the displacement of each vertex, or nothing if it moves none.
    std::vector<std::vector<Vector>> targets;

    /// those of vertex `v` are from `first_influence[v]` to `first_influence[v + 1]`, ascending by joint, their weights
    /// positive with sum 1; both empty without a skin.
    std::vector<Influence> influences;
    std::vector<std::size_t> first_influence;
  };

  struct Skin
  {
    std::vector<std::size_t> joints;            ///< nodes
    std::vector<Eigen::Affine3d> inverse_binds; ///< as many: from the geometry's coordinates to those of the joint
  };

  /// A geometry where it is drawn: at a node, or moved by a skin, of which the node's own place is no part.
  struct Part
  {
    std::size_t geometry = none;
    std::size_t node = none;
    std::size_t skin = none;
    std::vector<double> weights; ///< of the morph targets, as long as no clip says otherwise
    std::string name;            ///< as the file has it, for messages
  };

  enum class Path
  {
    TRANSLATION,
    ROTATION,
    SCALE,
    WEIGHTS ///< of all parts at the node
  };

  struct Channel
  {
    std::size_t node = none;
    Path path = Path::TRANSLATION;
    Keyframe_track track;
  };

  struct Clip
  {
    std::string name; ///< may be empty
    std::vector<Channel> channels;
  };

  std::vector<Node> nodes;
  std::vector<Geometry> geometries;
  std::vector<Skin> skins;
  std::vector<Part> parts; ///< their vertices, one part behind the other, are the file's
  std::vector<Clip> clips;

  /// what was left out, a sentence each: lines, for instance.
  std::vector<std::string> remarks;

  std::size_t number_of_vertices() const
  {
    std::size_t n = 0;
    for (const Part& part : parts) n += geometries[part.geometry].points.size();
    return n;
  }
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_KEYFRAMED_MODEL_H
