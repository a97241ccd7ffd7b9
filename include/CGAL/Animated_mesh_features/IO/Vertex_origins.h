// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_VERTEX_ORIGINS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_VERTEX_ORIGINS_H

#include <CGAL/Animated_mesh_features/IO/internal/Text_output.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesModels

Which vertices of a file the vertices of an animation are made of.

Formats for pictures split vertices where normals or textures jump, and models have several parts. The vertices of a
file are counted from 0 through all of its parts, one part after the other. Empty where vertices simply are those of
the file.
*/
struct Vertex_origins
{
  /// A mesh of the file.
  struct Part
  {
    std::string name;             ///< where it is in the file
    std::size_t first_vertex = 0; ///< of the file
    std::size_t vertices = 0;     ///< their number
  };

  /// the parts of the file, in its order.
  std::vector<Part> parts;

  std::vector<std::size_t> first;         ///< for each vertex where its rows in `file_vertices` begin; one more
  std::vector<std::size_t> file_vertices; ///< of vertex `v` from `first[v]` to `first[v + 1]`, ascending

  /// whether vertices simply are those of the file.
  bool empty() const { return first.empty(); }

  /// the number of vertices of the animation; 0 if `empty()`.
  std::size_t number_of_vertices() const { return first.empty() ? 0 : first.size() - 1; }

  /// the vertices of the file of which `v` is made: itself, if there are no origins.
  std::vector<std::size_t> of(std::size_t v) const
  {
    if (empty()) return {v};
    return std::vector<std::size_t>(file_vertices.begin() + std::ptrdiff_t(first[v]),
                                    file_vertices.begin() + std::ptrdiff_t(first[v + 1]));
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesModels

writes a table of comma-separated values, a line for each vertex of the file that belongs to a vertex: `file_vertex` and
`vertex`, both counted from 0, the number of its part, and its number within the part. Ascending by `vertex`.

Errors are left in the state of the stream; `Output_file` reports them.
*/
inline void write_vertex_map(std::ostream& os, const Vertex_origins& origins, std::size_t number_of_vertices)
{
  internal::Text_output out(os);
  out << "file_vertex,part,part_vertex,vertex\n";
  for (std::size_t v = 0; v < number_of_vertices; ++v)
    for (std::size_t i : origins.of(v)) {
      std::size_t part = 0;
      while (part + 1 < origins.parts.size() && origins.parts[part + 1].first_vertex <= i) ++part;
      const std::size_t first = origins.parts.empty() ? 0 : origins.parts[part].first_vertex;
      out << i << ',' << part << ',' << i - first << ',' << v << '\n';
    }
  out.flush();
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_VERTEX_ORIGINS_H
