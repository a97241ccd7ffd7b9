// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_REST_SHAPE_OF_MESH_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_REST_SHAPE_OF_MESH_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/internal/rest_points.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

makes the rest shape of a mesh that need not move: for features of a field of your own there is no need of an animation,
see `Feature_detector`. Vertices are numbered by their rank in `vertices(mesh)`, as the rows of the field have to be.

Linear in the size of the mesh.

\tparam TriangleMesh a model of `FaceListGraph`, `VertexListGraph` and `EdgeListGraph`, with dynamic vertex properties,
  whose faces are triangles.
\tparam VertexPointMap readable, vertex descriptor to a point of any \cgal kernel.
\param mesh is not kept.
\param points the position of each vertex.
\throw Input_error if a face is no triangle, a coordinate is not finite, or there are no faces.
*/
template <class TriangleMesh, class VertexPointMap>
Rest_shape rest_shape_of_mesh(const TriangleMesh& mesh, const VertexPointMap& points)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  const auto index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  std::vector<vertex_descriptor> descriptors;
  for (vertex_descriptor v : vertices(mesh)) {
    put(index, v, descriptors.size());
    descriptors.push_back(v);
  }
  Rest_shape shape(mesh, index, descriptors.size());
  shape.set_points(internal::rest_points(points, descriptors, "the mesh"));
  return shape;
}

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

the same with the mesh's own points, `get(CGAL::vertex_point, mesh)`.
*/
template <class TriangleMesh>
Rest_shape rest_shape_of_mesh(const TriangleMesh& mesh)
{
  return rest_shape_of_mesh(mesh, get(CGAL::vertex_point, mesh));
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_REST_SHAPE_OF_MESH_H
