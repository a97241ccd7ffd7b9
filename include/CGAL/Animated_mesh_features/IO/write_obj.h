// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_OBJ_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_OBJ_H

#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/internal/Text_output.h>

#include <array>
#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes a mesh as Wavefront OBJ: its points and triangles in their order, each coordinate with as many digits as it
takes to read the same number back. Independent of the stream's locale.

Errors are left in the state of the stream; `Output_file` reports them.
*/
inline void write_obj(std::ostream& os, const Indexed_mesh& mesh)
{
  internal::Text_output out(os);
  for (const std::array<double, 3>& p : mesh.points) out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const std::array<std::size_t, 3>& t : mesh.triangles)
    out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  out.flush();
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_OBJ_H
