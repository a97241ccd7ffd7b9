// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_TO_SURFACE_MESH_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_TO_SURFACE_MESH_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/internal/Corner_adjacency.h>
#include <CGAL/Animated_mesh_features/IO/internal/check_manifold.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

builds a surface mesh whose `i`-th vertex is the `i`-th point and whose `i`-th face is the `i`-th triangle. Points
without triangles become isolated vertices, so that ids stay those of the file.

The mesh is the one, down to the numbers of its halfedges, that adding the triangles one by one with
`CGAL::Euler::add_face()` gives. As they are known to fit together, nothing has to be looked for or joined anew: linear
time, some ten times faster.

\param mesh the points and triangles
\param name what the mesh is called in messages: its file

\throws Input_error if the triangles are not a consistently oriented 2-manifold, possibly with border: a face has a
vertex twice or a corner that is no vertex, an edge belongs to three faces, two faces run along an edge in the same
direction, the faces of a vertex do not hang together. The message names vertices and faces, counted from 0.
*/
template <class Point = Simple_cartesian<double>::Point_3>
Surface_mesh<Point> to_surface_mesh(const Indexed_mesh& mesh, const std::string& name)
{
  typedef Surface_mesh<Point> Mesh;
  typedef typename Mesh::Vertex_index Vertex_index;
  typedef typename Mesh::Halfedge_index Halfedge_index;
  typedef typename Mesh::size_type size_type;
  typedef internal::Corner_adjacency Adjacency;
  typedef Adjacency::Corner Corner;

  const Adjacency adjacency(mesh);
  if (!adjacency.is_manifold()) {
    internal::check_manifold(mesh, name);
    throw Input_error(name + ": the mesh is too large");
  }
  const auto vertex = [&](Corner c) { return Vertex_index(size_type(adjacency.vertex(c))); };
  const Corner corners = Corner(adjacency.number_of_corners());

  Mesh surface;
  surface.reserve(size_type(mesh.points.size()), size_type(adjacency.number_of_edges()),
                  size_type(mesh.triangles.size()));
  for (const std::array<double, 3>& p : mesh.points) surface.add_vertex(Point(p[0], p[1], p[2]));

  std::vector<Halfedge_index> halfedges(corners); // that of each corner's edge, in its triangle
  for (Corner c = 0; c < corners; ++c) {
    const Corner twin = adjacency.twin(c);
    halfedges[c] =
        twin < c ? surface.opposite(halfedges[twin]) : surface.add_edge(vertex(c), vertex(Adjacency::next(c)));
  }
  for (Corner c = 0; c < corners; c += 3) {
    const auto face = surface.add_face();
    surface.set_halfedge(face, halfedges[c + 2]);
    for (Corner i = c; i < c + 3; ++i) {
      surface.set_face(halfedges[i], face);
      surface.set_next(halfedges[i], halfedges[Adjacency::next(i)]);
      surface.set_halfedge(vertex(i), halfedges[Adjacency::previous(i)]); // the last face has the last word
    }
  }
  for (Corner c = 0; c < corners; ++c) {
    if (adjacency.twin(c) != Adjacency::none) continue;
    // The border comes back along this edge and leaves its vertex where the fan of triangles ends.
    Corner last = Adjacency::previous(c);
    while (adjacency.twin(last) != Adjacency::none) last = Adjacency::previous(adjacency.twin(last));
    surface.set_next(surface.opposite(halfedges[c]), surface.opposite(halfedges[last]));
    surface.set_halfedge(vertex(c), surface.opposite(halfedges[c])); // a border halfedge, as CGAL has it
  }
  return surface;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_TO_SURFACE_MESH_H
