// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_CHECK_SAME_CONNECTIVITY_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_CHECK_SAME_CONNECTIVITY_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

checks that a mesh has as many vertices as a reference, and the same triangles in the same order. Linear in their size.

\param reference,name_of_reference a mesh, and its file for messages
\param mesh,name the mesh to be checked, and its file

\throws Input_error if it differs. The message names the first triangle that does.
*/
inline void check_same_connectivity(const Indexed_mesh& reference, const std::string& name_of_reference,
                                    const Indexed_mesh& mesh, const std::string& name)
{
  const auto compare = [&](std::size_t n, std::size_t m, const char* what) {
    if (n != m)
      throw Input_error(name + ": has " + std::to_string(m) + what + ", but " + name_of_reference + " has " +
                        std::to_string(n) + "; the connectivity must be the same");
  };
  compare(reference.points.size(), mesh.points.size(), " vertices");
  compare(reference.triangles.size(), mesh.triangles.size(), " triangles");
  const auto face = std::mismatch(reference.triangles.begin(), reference.triangles.end(), mesh.triangles.begin());
  if (face.first == reference.triangles.end()) return;
  const auto text = [](const std::array<std::size_t, 3>& t) {
    return "(" + std::to_string(t[0]) + ", " + std::to_string(t[1]) + ", " + std::to_string(t[2]) + ")";
  };
  throw Input_error(name + ": triangle " + std::to_string(face.first - reference.triangles.begin()) + " is " +
                    text(*face.second) + ", but " + text(*face.first) + " in " + name_of_reference +
                    "; the connectivity must be the same");
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_CHECK_SAME_CONNECTIVITY_H
