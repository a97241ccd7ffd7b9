// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_WELDING_REMARKS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_WELDING_REMARKS_H

#include <CGAL/Animated_mesh_features/IO/weld_surface.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

inline std::string counted(std::size_t n, const char* singular, const char* plural)
{
  return std::to_string(n) + " " + (n == 1 ? singular : plural);
}

inline std::vector<std::string> welding_remarks(const Welded_surface& w, std::size_t file_vertices)
{
  std::vector<std::string> remarks;
  if (w.number_of_vertices() != file_vertices || w.welded_edges > 0)
    remarks.push_back(counted(file_vertices, "vertex", "vertices") + " of the file became " +
                      std::to_string(w.number_of_vertices()) +
                      (w.welded_edges == 0 ? "" : ", " + counted(w.welded_edges, "edge was", "edges were") + " sewn"));
  if (w.unused_vertices > 0)
    remarks.push_back(counted(w.unused_vertices, "vertex", "vertices") + " in no triangle left out");
  if (w.collapsed_triangles > 0)
    remarks.push_back(counted(w.collapsed_triangles, "triangle", "triangles") + " without area in any frame left out");
  if (w.split_vertices > 0)
    remarks.push_back(counted(w.split_vertices, "vertex", "vertices") +
                      " split where the surface meets in a point only");
  if (w.open_edges > 0)
    remarks.push_back(counted(w.open_edges, "edge", "edges") +
                      " left open: borders coincide there, but do not make a manifold");
  return remarks;
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_WELDING_REMARKS_H
