// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_READ_MESH_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_READ_MESH_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/Mesh_reading_options.h>
#include <CGAL/Animated_mesh_features/IO/file_format.h>
#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>
#include <CGAL/Animated_mesh_features/IO/internal/parse_obj.h>
#include <CGAL/Animated_mesh_features/IO/internal/parse_off.h>
#include <CGAL/Animated_mesh_features/IO/internal/parse_ply.h>
#include <CGAL/Animated_mesh_features/IO/internal/parse_stl.h>

#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

// The form for many files: the memory of `content` and `mesh` is reused. Returns whether the triangles are those of
// `reference`; if so, `mesh` has points only.
inline bool read_mesh(const std::string& path, const Mesh_reading_options& options, std::string& content,
                      Indexed_mesh& mesh, const Indexed_mesh* reference = nullptr)
{
  const File_format format = file_format_by_ending(path);
  if (!is_mesh(format))
    throw Input_error(path + ": unknown kind of mesh file \"" + file_ending(path) +
                      "\"; known are .obj, .off, .ply and .stl");
  read_content(path, content);
  if (content.empty()) throw Input_error(path + ": is empty");
  if (format == File_format::OBJ) return parse_obj(content, path, options, mesh, reference);
  if (format == File_format::OFF) return parse_off(content, path, options, mesh, reference);
  if (format == File_format::PLY) return parse_ply(content, path, options, mesh, reference);
  return parse_stl(content, path, options, mesh, reference);
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

reads a triangle mesh from an OBJ, OFF (ASCII), PLY (ASCII or binary) or STL file (ASCII or binary); the ending of its
name tells which, in either case of letters. Vertices and faces keep their order.

Of OFF all forms whose vertices begin with three coordinates are read (`COFF`, `STCNOFF`...), of PLY faces and strips of
triangles. In ASCII PLY a vertex or a face is a line, with as many values as the header announces.

STL has no vertices of its own: corners with equal coordinates become one vertex, in the order of their first use.

Nothing depends on the locale. Linear in the size of the file, which is held in memory meanwhile.

\throws Input_error if the file cannot be read, is malformed or ends early, has no vertices or no faces, has a
coordinate that is not finite, a corner that is no vertex, or a face with more than three corners (see
`Mesh_reading_options::triangulate_faces`). The message names the file and, as far as there are such, the line, the
vertex or the face, the latter two counted from 0.
*/
inline Indexed_mesh read_mesh(const std::string& path, Mesh_reading_options options = Mesh_reading_options())
{
  Indexed_mesh mesh;
  std::string content;
  internal::read_mesh(path, options, content, mesh);
  return mesh;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_READ_MESH_H
