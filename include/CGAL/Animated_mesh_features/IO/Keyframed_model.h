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
\ingroup PkgAnimatedMeshFeaturesModels

What files of animated models hold, whatever their format: a tree of nodes with a transformation each, triangle meshes
that are attached to nodes or to skeletons of nodes and have morph targets, and clips, which change transformations and
weights with time. Readers of formats fill it; `Keyframed_model_evaluator` tells where the vertices are at a time.

Whatever refers to something else does so by its index. The semantics are those of glTF 2.0.
*/
struct Keyframed_model
{
  /// stands for no index.
  static constexpr std::size_t none = std::size_t(-1);

  /// a position, a displacement or a scale.
  typedef std::array<double, 3> Vector;

  /// A node's transformation, relative to its parent, is its `matrix` if it has one and no clip moves it; else a scale,
  /// followed by a rotation (x, y, z, w), followed by a translation.
  struct Node
  {
    std::string name;                                ///< may be empty
    std::size_t parent = none;                       ///< a node, or `none` for a root
    std::optional<Eigen::Affine3d> matrix;           ///< to the parent's coordinates
    Vector translation = {{0, 0, 0}};                ///< length
    std::array<double, 4> rotation = {{0, 0, 0, 1}}; ///< a quaternion x, y, z, w of length 1
    Vector scale = {{1, 1, 1}};                      ///< along the node's axes
  };

  /// A vertex moves with the node `joint` of its skin with this weight.
  struct Influence
  {
    std::size_t joint; ///< rank in `Skin::joints`
    double weight;     ///< positive
  };

  /// A triangle mesh with its morph targets and its attachment to a skeleton.
  struct Geometry
  {
    std::vector<Vector> points;                        ///< in the coordinates of the geometry
    std::vector<std::array<std::size_t, 3>> triangles; ///< of indices of points

    /// for each vertex where it is in the texture, or none; see read_gltf().
    std::vector<std::array<double, 2>> texture_coordinates;

    /// for each morph target the displacement of each vertex, or nothing if it moves none.
    std::vector<std::vector<Vector>> targets;

    /// those of vertex `v` are from `first_influence[v]` to `first_influence[v + 1]`, ascending by joint, their weights
    /// positive with sum 1; both empty without a skin.
    std::vector<Influence> influences;
    std::vector<std::size_t> first_influence; ///< one more than points, or none
  };

  /// A skeleton: the nodes that move a geometry.
  struct Skin
  {
    std::vector<std::size_t> joints;            ///< nodes
    std::vector<Eigen::Affine3d> inverse_binds; ///< as many: from the geometry's coordinates to those of the joint
  };

  /// A geometry where it is drawn: at a node, or moved by a skin, of which the node's own place is no part.
  struct Part
  {
    std::size_t geometry = none; ///< what is drawn
    std::size_t node = none;     ///< where it hangs in the tree
    std::size_t skin = none;     ///< what moves it instead, or `none`
    std::vector<double> weights; ///< of the morph targets, as long as no clip says otherwise
    std::string name;            ///< as the file has it, for messages
    std::string mesh = {};       ///< the name of the mesh that the geometry is of; may be empty
    std::size_t primitive = 0;   ///< which of that mesh's pieces it is
  };

  /// What of a node a channel changes.
  enum class Path
  {
    TRANSLATION, ///< `Node::translation`
    ROTATION,    ///< `Node::rotation`
    SCALE,       ///< `Node::scale`
    WEIGHTS      ///< `Part::weights` of all parts at the node
  };

  /// One number or vector that changes with time.
  struct Channel
  {
    std::size_t node = none;       ///< whose
    Path path = Path::TRANSLATION; ///< what of it
    Keyframe_track track;          ///< its values
  };

  /// An animation of the model. What no channel changes is as the nodes and parts say.
  struct Clip
  {
    std::string name;              ///< may be empty
    std::vector<Channel> channels; ///< in any order
  };

  std::vector<Node> nodes;          ///< in any order
  std::vector<Geometry> geometries; ///< each may be drawn several times
  std::vector<Skin> skins;          ///< each may move several parts
  std::vector<Part> parts;          ///< their vertices, one part after the other, are the file's
  std::vector<Clip> clips;          ///< one of them is played

  /// files that belong to the model besides its own: those of its buffers.
  std::vector<std::string> linked_files;

  /// what was left out, a sentence each: lines, for instance.
  std::vector<std::string> remarks;

  /// that of all parts together.
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
