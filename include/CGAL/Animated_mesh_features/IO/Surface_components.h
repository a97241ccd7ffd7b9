// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_SURFACE_COMPONENTS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_SURFACE_COMPONENTS_H

#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/Numerics/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

The connected components of a mesh, the one with the most vertices first; of those with as many, the one with the least
vertex. Triangles are connected if they have a vertex in common; a vertex in no triangle belongs to none.
*/
struct Surface_components
{
  std::vector<std::size_t> of_triangle; ///< for each triangle its component, counted from 0
  std::vector<std::size_t> vertices;    ///< for each component how many it has

  /// In almost linear time.
  explicit Surface_components(const Indexed_mesh& mesh)
  {
    const std::size_t n = mesh.points.size();
    std::vector<std::size_t> rank(n, 0), parent(n), size(n, 0), component(n, 0);
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    auto sets = Animated_mesh_features::internal::disjoint_sets(rank.data(), parent.data());
    std::vector<char> is_used(n, 0);
    for (const std::array<std::size_t, 3>& t : mesh.triangles) {
      sets.union_set(t[0], t[1]);
      sets.union_set(t[1], t[2]);
      for (std::size_t v : t) is_used[v] = 1;
    }
    std::vector<std::size_t> roots; // by the least vertex of each component
    for (std::size_t v = 0; v < n; ++v) {
      if (!is_used[v]) continue;
      const std::size_t root = sets.find_set(v);
      if (size[root]++ == 0) roots.push_back(root);
    }
    std::stable_sort(roots.begin(), roots.end(), [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
    for (std::size_t i = 0; i < roots.size(); ++i) {
      component[roots[i]] = i;
      vertices.push_back(size[roots[i]]);
    }
    for (const std::array<std::size_t, 3>& t : mesh.triangles) of_triangle.push_back(component[sets.find_set(t[0])]);
  }
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_SURFACE_COMPONENTS_H
