// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_ANIMATION_REPORT_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_ANIMATION_REPORT_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

What is unusual about a mesh and nevertheless allowed. Each of it is handled: a degenerate rest triangle has no
strain and is left out of its vertices' means; components and borders end the smoothing and the geodesic balls; an
isolated vertex has no deformation and no features.
*/
struct Animation_report
{
  std::size_t degenerate_rest_triangles = 0; ///< see `is_degenerate()`
  std::size_t connected_components = 0;      ///< isolated vertices not counted
  std::size_t border_edges = 0;              ///< edges with a triangle on one side only
  std::size_t isolated_vertices = 0;         ///< vertices without edges
};

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

A rest triangle is degenerate if its height over its longest edge is below this fraction of that edge: its inverse,
and with it every strain, would have lost half of the digits of a `double`.
*/
constexpr double degenerate_height_ratio = 1e-8;

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

whether the `t`-th triangle of the rest shape is degenerate; see `degenerate_height_ratio`.
*/
inline bool is_degenerate(const Rest_shape& shape, std::size_t t)
{
  const auto& corners = shape.triangles()[t];
  double longest = 0;
  for (int i = 0; i < 3; ++i)
    longest = (std::max)(longest,
                         (shape.points()[corners[i]] - shape.points()[corners[(i + 1) % 3]]).squaredNorm());
  return !(2 * shape.areas()[t] > degenerate_height_ratio * longest);
}

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

counts what is unusual about a mesh in its rest shape. Linear in the size of the mesh.
*/
inline Animation_report report(const Rest_shape& shape)
{
  Animation_report r;
  for (std::size_t t = 0; t < shape.triangles().size(); ++t) r.degenerate_rest_triangles += is_degenerate(shape, t);
  for (const Rest_shape::Edge& e : shape.edges()) r.border_edges += e.is_border();
  std::vector<char> seen(shape.number_of_vertices(), 0);
  std::vector<Rest_shape::Index> front;
  for (std::size_t v = 0; v < shape.number_of_vertices(); ++v) {
    if (shape.neighbours()[v].empty()) ++r.isolated_vertices;
    if (seen[v] || shape.neighbours()[v].empty()) continue;
    ++r.connected_components;
    seen[v] = 1;
    front.assign(1, Rest_shape::Index(v));
    while (!front.empty()) {
      const Rest_shape::Index u = front.back();
      front.pop_back();
      for (Rest_shape::Index w : shape.neighbours()[u])
        if (!seen[w]) {
          seen[w] = 1;
          front.push_back(w);
        }
    }
  }
  return r;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_ANIMATION_REPORT_H
