// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_COLLAPSE_SETTINGS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_COLLAPSE_SETTINGS_H

#include <CGAL/Animated_mesh_features/Applications/Simplification_options.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_collapses.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// frames in the order of columns: poses, then all others
inline std::vector<std::size_t> pose_columns(const std::vector<std::size_t>& poses, std::size_t frames)
{
  std::vector<std::size_t> columns = poses;
  std::vector<char> is_pose(frames, 0);
  for (std::size_t f : poses) is_pose[f] = 1;
  for (std::size_t f = 0; f < frames; ++f)
    if (is_pose[f] == 0) columns.push_back(f);
  return columns;
}

inline std::vector<char> fixed_vertices(const Simplification_options& o, std::size_t vertices)
{
  std::vector<char> is_fixed(vertices, 0);
  for (std::size_t v : o.fixed_vertices) {
    if (v >= vertices)
      throw Option_error("there is no vertex " + std::to_string(v) + " to be fixed; the mesh has " +
                         std::to_string(vertices));
    is_fixed[v] = 1;
  }
  return is_fixed;
}

inline Pose_collapses::Settings collapse_settings(const Simplification_options& o)
{
  const auto check = [](double x, double most, const char* what) {
    if (!(x >= 0 && x <= most)) throw Option_error(std::string(what) + " is " + std::to_string(x) + ", out of range");
  };
  check(o.line_weight, 1e6, "the line weight");
  check(o.border_weight, 1e6, "the border weight");
  check(o.least_cosine, .999, "the least cosine");
  if (o.support == 0 || o.support > 64) throw Option_error("a vertex can follow 1 to 64 vertices");
  return {o.line_weight, o.border_weight, o.least_cosine, o.support};
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_COLLAPSE_SETTINGS_H
