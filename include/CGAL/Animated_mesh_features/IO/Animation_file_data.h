// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_ANIMATION_FILE_DATA_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_ANIMATION_FILE_DATA_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/Vertex_origins.h>
#include <CGAL/Animated_mesh_features/IO/file_format.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

An animation as its files hold it: `N` vertices, `F` frames.
*/
template <class FT>
struct Animation_file_data
{
  /// the connectivity, and the points of the mesh file: those of the first frame for a sequence of meshes.
  Indexed_mesh mesh;

  /// `F`
  std::size_t frames = 0;

  /// where the vertices of an animated model are without any clip, its bind pose as a rule; empty for other inputs, and if
  /// a position is not finite.
  std::vector<std::array<double, 3>> bind_points;

  /// the time of each frame (s) if the file tells it (MDD, clips of models), else empty.
  std::vector<double> times;

  Spatio_temporal_field<FT> x; ///< coordinates, `N x F`
  Spatio_temporal_field<FT> y; ///< coordinates, `N x F`
  Spatio_temporal_field<FT> z; ///< coordinates, `N x F`

  /// the files: mesh and cache, or a mesh for each frame, in their order.
  std::vector<std::string> sources;

  /// further files that those refer to: the buffers of a model.
  std::vector<std::string> linked_files;

  /// the names of all animations in the file; empty where there is but one, without a name.
  std::vector<std::string> clips;

  /// which of them this is.
  std::size_t clip = 0;

  /// which others are played together with it.
  std::vector<std::size_t> further_clips;

  /// empty if vertices are those of the file.
  Vertex_origins origins;

  /// the names that the file gives to parts of the surface, in its order, each once: of OBJ those of objects and groups, of
  /// models those of nodes and meshes.
  std::vector<std::string> part_names;

  /// the mesh as its file has it, if vertices were welded or the surface was repaired (see `weld_animation()`), or only a
  /// part of it was taken; else empty.
  Indexed_mesh file_mesh;

  /// what was left out or changed on reading, for the user: a sentence each.
  std::vector<std::string> remarks;

  /// what must be known to judge the result, for the user in any case: a sentence each.
  std::vector<std::string> notices;

  /// where a frame comes from, for messages.
  std::string frame_name(std::size_t frame) const
  {
    return is_mesh(file_format_by_ending(sources.back())) ? sources[frame]
                                                          : sources.back() + ", frame " + std::to_string(frame);
  }
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_ANIMATION_FILE_DATA_H
