// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_MESH_READING_OPTIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_MESH_READING_OPTIONS_H

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

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
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_MESH_READING_OPTIONS_H
