// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_VERTEX_AREAS_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_VERTEX_AREAS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

computes the share of the surface that each vertex stands for: a third of the area of each of its triangles (squared
length), 0 without triangles. Their sum is the area of the surface. Linear time; the same bits whatever the order of the
mesh's faces.

\returns `N` areas.
*/
inline std::vector<double> vertex_areas(const Rest_shape& shape)
{
  std::vector<double> areas(shape.number_of_vertices(), 0.);
  for (std::size_t v = 0; v < areas.size(); ++v)
    for (Rest_shape::Index t : shape.incident_triangles()[v]) areas[v] += shape.areas()[t] / 3;
  return areas;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_VERTEX_AREAS_H
