// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_OBJ_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_OBJ_H

#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesIO

writes a mesh as Wavefront OBJ: its points and triangles in their order, each coordinate with as many digits as it
takes to read the same number back. Independent of the stream's locale.

Errors are left in the state of the stream; `Output_file` reports them.
*/
inline void write_obj(std::ostream& os, const Indexed_mesh& mesh)
{
  const std::size_t block = 1 << 16; // many lines for each call of the stream
  std::string text;
  for (const std::array<double, 3>& p : mesh.points) {
    text += 'v';
    for (double x : p) {
      text += ' ';
      internal::append_number(text, x);
    }
    text += '\n';
    if (text.size() >= block) {
      os.write(text.data(), static_cast<std::streamsize>(text.size()));
      text.clear();
    }
  }
  for (const std::array<std::size_t, 3>& t : mesh.triangles) {
    text += 'f';
    for (std::size_t i : t) {
      text += ' ';
      internal::append_number(text, i + 1);
    }
    text += '\n';
    if (text.size() >= block) {
      os.write(text.data(), static_cast<std::streamsize>(text.size()));
      text.clear();
    }
  }
  os.write(text.data(), static_cast<std::streamsize>(text.size()));
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_OBJ_H
