// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_FEATURE_FILE_DATA_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_FEATURE_FILE_DATA_H

#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/IO/Result_description.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

Features as a file holds them: all that `write_json()` writes, and what `read_json()` gives back.
*/
struct Feature_file_data
{
  /// the animation on which the features were found, and the parameters of their detection. Of its `origins` a file has
  /// the parts only; what it knows of vertices is in `file_vertices`.
  Result_description description;

  /// in the order of the file.
  std::vector<Feature_point> features;

  /// for each feature the vertices of the animation's file of which its vertex is made, see `Vertex_origins`; empty if
  /// vertices are those of the file.
  std::vector<std::vector<std::size_t>> file_vertices;
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_FEATURE_FILE_DATA_H
