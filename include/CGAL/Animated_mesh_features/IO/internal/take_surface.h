// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_TAKE_SURFACE_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_TAKE_SURFACE_H

#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/weld_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

template <class FT>
void take_rows(const std::vector<std::size_t>& rows, std::size_t frames, Spatio_temporal_field<FT>& field)
{
  Spatio_temporal_field<FT> taken(rows.size(), frames, field.memory());
  for (std::size_t i = 0; i < rows.size(); ++i) std::copy_n(field.row(rows[i]), frames, taken.row(i));
  field.swap(taken);
}

// Those of vertices that are made of vertices with origins of their own.
inline Vertex_origins composed_origins(const Vertex_origins& origins, const Welded_surface& surface)
{
  Vertex_origins result;
  result.parts = origins.parts;
  result.first = {0};
  for (std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    const std::size_t begin = result.file_vertices.size();
    for (std::size_t i = surface.first[v]; i < surface.first[v + 1]; ++i)
      for (std::size_t w : origins.of(surface.file_vertices[i])) result.file_vertices.push_back(w);
    std::sort(result.file_vertices.begin() + std::ptrdiff_t(begin), result.file_vertices.end());
    result.first.push_back(result.file_vertices.size());
  }
  return result;
}

// Makes the vertices those of a surface that was welded, or taken out, of the present one.
template <class FT>
void take_surface(Welded_surface surface, Animation_file_data<FT>& data)
{
  std::vector<std::size_t> rows(surface.number_of_vertices()); // the first of those of the present surface
  for (std::size_t v = 0; v < rows.size(); ++v) rows[v] = surface.file_vertices[surface.first[v]];
  Indexed_mesh mesh;
  std::vector<std::array<double, 3>> bind_points;
  for (std::size_t v : rows) {
    mesh.points.push_back(data.mesh.points[v]);
    if (!data.bind_points.empty()) bind_points.push_back(data.bind_points[v]);
  }
  mesh.triangles = std::move(surface.triangles);
  if (data.origins.empty()) {
    const std::string name = std::filesystem::path(data.sources.front()).filename().string();
    data.origins.parts = {{name, 0, data.mesh.points.size()}};
    data.origins.first = std::move(surface.first);
    data.origins.file_vertices = std::move(surface.file_vertices);
    data.file_mesh = std::move(data.mesh);
  } else {
    data.origins = composed_origins(data.origins, surface);
  }
  data.mesh = std::move(mesh);
  data.bind_points = std::move(bind_points);
  for (Spatio_temporal_field<FT>* field : {&data.x, &data.y, &data.z}) take_rows(rows, data.frames, *field);
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_TAKE_SURFACE_H
