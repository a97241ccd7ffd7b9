// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFICATION_LIMITS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFICATION_LIMITS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

Between which numbers of vertices a mesh can be simplified, whatever its shape.
*/
struct Simplification_limits
{
  std::size_t used = 0;       ///< the vertices that belong to faces
  std::size_t least = 0;      ///< four for each closed component, three for each with a border
  std::size_t components = 0; ///< of the surface

  /// looks at the connectivity, in linear time.
  explicit Simplification_limits(const Rest_shape& rest)
  {
    std::vector<char> is_seen(rest.number_of_vertices(), 0);
    std::vector<Rest_shape::Index> stack;
    for (std::size_t v = 0; v < is_seen.size(); ++v) {
      if (is_seen[v] != 0 || rest.is_isolated(v)) continue;
      bool has_border = false;
      is_seen[v] = 1;
      stack.assign(1, Rest_shape::Index(v));
      while (!stack.empty()) {
        const Rest_shape::Index u = stack.back();
        stack.pop_back();
        ++used;
        has_border = has_border || rest.is_border(u);
        for (Rest_shape::Index w : rest.neighbours()[u]) {
          if (is_seen[w] != 0) continue;
          is_seen[w] = 1;
          stack.push_back(w);
        }
      }
      ++components;
      least += has_border ? 3 : 4;
    }
  }
};

namespace internal {

// throws Option_error; returns the number of vertices that belong to faces.
inline std::size_t check_targets(const Rest_shape& rest, const std::vector<std::size_t>& targets)
{
  const Simplification_limits needed(rest);
  if (targets.empty()) throw Option_error("how many vertices are to be left?");
  std::size_t before = needed.used + 1;
  for (std::size_t target : targets) {
    const std::string wanted = std::to_string(target) + " vertices are wanted, ";
    if (target > needed.used)
      throw Option_error(wanted + "the mesh has " + std::to_string(needed.used) + " that belong to faces");
    if (target >= before)
      throw Option_error(wanted + "not fewer than the " + std::to_string(before) + " of the level before");
    if (target < needed.least)
      throw Option_error(wanted + "but " + std::to_string(needed.components) +
                         (needed.components == 1 ? " component takes " : " components take ") +
                         std::to_string(needed.least) + " at least");
    before = target;
  }
  return needed.used;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFICATION_LIMITS_H
