// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_COMPONENTS_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_COMPONENTS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Which triangles meet at an edge, and which edges bound a triangle.
struct Triangle_adjacency
{
  typedef Rest_shape::Index Index;

  // One side of an edge: the triangle and the corner at which the edge starts there. The left triangle runs from
  // `source` to `target`, the right one back. `triangle` is `Rest_shape::none` at a border.
  struct Side
  {
    Index triangle = Rest_shape::none;
    unsigned corner = 0;
  };

  std::vector<std::array<Side, 2>> sides;  // of each edge: left, right
  std::vector<std::array<Index, 3>> edges; // of each triangle: from corner k to corner k + 1

  explicit Triangle_adjacency(const Rest_shape& shape)
    : sides(shape.edges().size())
    , edges(shape.triangles().size(), {{Rest_shape::none, Rest_shape::none, Rest_shape::none}})
  {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const Rest_shape::Edge& e = shape.edges()[i];
      if (e.left != Rest_shape::none) sides[i][0] = claim(shape, Index(i), e.source, e.target, e.left);
      if (e.right != Rest_shape::none) sides[i][1] = claim(shape, Index(i), e.target, e.source, e.right);
    }
  }

  bool is_interior(std::size_t e) const
  {
    return sides[e][0].triangle != Rest_shape::none && sides[e][1].triangle != Rest_shape::none;
  }

  // the triangle on the other side of edge `k` of triangle `t`, or none.
  Index neighbour(std::size_t t, unsigned k) const
  {
    const std::array<Side, 2>& s = sides[edges[t][k]];
    return s[0].triangle == t && s[0].corner == k ? s[1].triangle : s[0].triangle;
  }

private:
  // A corner is claimed once, so that two triangles on the same three vertices are kept apart.
  Side claim(const Rest_shape& shape, Index edge, Index from, Index to, Index third)
  {
    for (Index t : shape.incident_triangles()[from]) {
      const Rest_shape::Triangle& v = shape.triangles()[t];
      for (unsigned k = 0; k < 3; ++k)
        if (v[k] == from && v[(k + 1) % 3] == to && v[(k + 2) % 3] == third && edges[t][k] == Rest_shape::none) {
          edges[t][k] = edge;
          Side side;
          side.triangle = t;
          side.corner = k;
          return side;
        }
    }
    return Side();
  }
};

// A connected part of the surface, by the indices of the whole.
struct Surface_component
{
  std::vector<Rest_shape::Index> vertices, edges; // ascending
  std::vector<Rest_shape::Index> triangles;       // by their vertices, so that no result depends on the order of faces
};

// The components in the order of their smallest vertices; an isolated vertex is one without triangles.
// Complexity: linear.
inline std::vector<Surface_component> surface_components(const Rest_shape& shape)
{
  typedef Rest_shape::Index Index;
  std::vector<Index> component(shape.number_of_vertices(), Rest_shape::none), stack;
  std::vector<Surface_component> result;
  for (std::size_t v = 0; v < component.size(); ++v) {
    if (component[v] != Rest_shape::none) continue;
    component[v] = Index(result.size());
    stack.push_back(Index(v));
    while (!stack.empty()) {
      const Index i = stack.back();
      stack.pop_back();
      for (Index j : shape.neighbours()[i])
        if (component[j] == Rest_shape::none) {
          component[j] = component[i];
          stack.push_back(j);
        }
    }
    result.emplace_back();
  }
  for (std::size_t v = 0; v < component.size(); ++v) result[component[v]].vertices.push_back(Index(v));
  for (std::size_t e = 0; e < shape.edges().size(); ++e)
    result[component[shape.edges()[e].source]].edges.push_back(Index(e));
  for (Index t : shape.ordered_triangles()) result[component[shape.triangles()[t][0]]].triangles.push_back(t);
  return result;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_COMPONENTS_H
