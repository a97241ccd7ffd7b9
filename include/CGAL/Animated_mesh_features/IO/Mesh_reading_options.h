// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_MESH_READING_OPTIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_MESH_READING_OPTIONS_H

#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

What is done with vertices of a mesh that lie at the same place in all frames; see `weld_animation()`.
*/
enum class Welding
{
  AUTO,   ///< they are welded where that closes a seam and makes a manifold, else left as they are
  ALWAYS, ///< the same, but where it does not make a manifold the file is refused
  NEVER   ///< they are left as they are
};

/*!
\ingroup PkgAnimatedMeshFeaturesReading

Options of `read_mesh()` and `read_animation()`.
*/
struct Mesh_reading_options
{
  /// cut faces with more than three corners into triangles, as a fan around the face's first corner. The same face is
  /// cut in the same way in every frame, whatever its shape. By default such a face is an error, since the diagonals,
  /// which nobody modelled, take part in all that is measured.
  bool triangulate_faces = false;

  /// take a list of mesh files as the frames in the order in which it is given, whatever numbers are in their names. By
  /// default they must be a `numbered_series()`, since a shell expands `walk*.obj` to `walk_10.obj walk_2.obj`.
  bool frames_as_given = false;

  /// what is done with coincident vertices. By default seams, along which exporters cut a surface open where textures or
  /// normals jump, are closed: to the method, the two sides of a seam would be far from each other.
  Welding welding = Welding::AUTO;

  /// mend a mesh that is no oriented manifold (`repair_triangles()`). By default it is an error, since what is meant is not
  /// always what the repair makes of it.
  bool repair = false;

  /// leave out frames that are broken, and bridge them in time (`check_frames()`). By default they are an error: what makes
  /// one frame bad is often wrong with others, too.
  bool skip_bad_frames = false;

  /// which part of the surface is taken: an object or a group of an OBJ file by its name, or else a connected component by
  /// its number; empty: all. See `weld_part()`.
  std::string part;
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_MESH_READING_OPTIONS_H
