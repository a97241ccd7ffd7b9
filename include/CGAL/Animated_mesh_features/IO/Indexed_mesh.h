// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INDEXED_MESH_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INDEXED_MESH_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

A triangle mesh as a file holds it: `N` points and `M` triples of their indices, both in the file's order and counted
from 0. It may be anything; `to_surface_mesh()` tells whether it is a surface.
*/
struct Indexed_mesh
{
  /// Triangles that the file gives names to: those from `first_triangle` to that of the next group.
  struct Group
  {
    std::vector<std::string> names; ///< of OBJ the object (`o`) and its groups (`g`)
    std::size_t first_triangle = 0; ///< in `triangles`
  };

  std::vector<std::array<double, 3>> points;         ///< `N`
  std::vector<std::array<std::size_t, 3>> triangles; ///< `M`, of indices of points

  /// ascending; empty if the file names nothing. Only OBJ does.
  std::vector<Group> groups;

  /// what is unusual in the file but does no harm: a sentence each.
  std::vector<std::string> remarks;
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INDEXED_MESH_H
