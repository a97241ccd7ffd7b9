// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_WELD_ANIMATION_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_WELD_ANIMATION_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/Coincident_vertices.h>
#include <CGAL/Animated_mesh_features/IO/Mesh_reading_options.h>
#include <CGAL/Animated_mesh_features/IO/internal/Corner_adjacency.h>
#include <CGAL/Animated_mesh_features/IO/internal/take_surface.h>
#include <CGAL/Animated_mesh_features/IO/internal/welding_remarks.h>
#include <CGAL/Animated_mesh_features/IO/repair_triangles.h>
#include <CGAL/Animated_mesh_features/IO/weld_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

template <class FT>
Coincident_vertices coincident_vertices(const Animation_file_data<FT>& data)
{
  Coincident_vertices coincident(data.x.number_of_rows());
  for (std::size_t f = 0; f < data.frames && !coincident.all_apart(); ++f)
    coincident.add_positions([&](std::size_t v) {
      return std::array<double, 3>{{double(data.x(v, f)), double(data.y(v, f)), double(data.z(v, f))}};
    });
  return coincident;
}

inline std::vector<std::string> repair_remarks(const Repaired_triangles& r)
{
  std::vector<std::string> remarks;
  const auto add = [&](std::size_t n, const char* one, const char* several, const std::string& what) {
    if (n > 0) remarks.push_back("repair: " + counted(n, one, several) + what);
  };
  add(r.collapsed, "face", "faces", " with the same vertex twice left out");
  add(r.repeated, "face", "faces", " with the vertices of another face left out");
  add(r.turned_round, "face", "faces", " turned round to agree with their neighbours");
  add(r.branching_edges, "edge", "edges", " cut open where more than two faces meet");
  return remarks;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

closes the seams of an animation that was read, and mends its surface, as the options say: vertices at the same place in
all frames, bit for bit, are welded as those of models are (see `Coincident_vertices` and `weld_surface()`). Nothing is
changed if there is nothing to be closed or mended; otherwise `Animation_file_data::origins` tells which vertices of the
file each vertex is made of, `notices` what was done, and `file_mesh` is what was read. A mesh that is no manifold is
left as it is, unless it is to be repaired.

Expected time linear in the number of vertices, and in `F` times that of coincident ones; memory for one more field while
vertices are taken over.

\throws Input_error if seams that must be closed cannot be, or see `repair_triangles()`; no triangle is left.
*/
template <class FT>
void weld_animation(Welding welding, bool repair, Animation_file_data<FT>& data)
{
  const std::string& file = data.sources.front();
  if (!repair && (welding == Welding::NEVER || !internal::Corner_adjacency(data.mesh).is_manifold())) return;
  const std::size_t n = data.mesh.points.size();
  std::vector<std::size_t> place(n);
  std::iota(place.begin(), place.end(), std::size_t(0));
  if (welding != Welding::NEVER) place = internal::coincident_vertices(data).first_of_class();
  std::size_t coincident = 0;
  for (std::size_t v = 0; v < n; ++v) coincident += place[v] != v;

  Repaired_triangles repaired;
  if (repair) repaired = repair_triangles(data.mesh.triangles, n, file);
  const bool is_mended = repaired.collapsed + repaired.repeated + repaired.turned_round > 0;
  if (coincident == 0 && !is_mended && internal::Corner_adjacency(data.mesh).is_manifold()) return;

  Welded_surface surface = weld_surface(repair ? repaired.triangles : data.mesh.triangles, place);
  const std::string what =
      internal::counted(coincident, "vertex lies", "vertices lie") + " where another one does in all frames";
  if (welding == Welding::ALWAYS && surface.open_edges > 0)
    throw Input_error(file + ": " + what + ", but welding would not make a manifold at " +
                      internal::counted(surface.open_edges, "edge", "edges") +
                      "; with the welding AUTO (command line: --weld auto) these are left open");
  if (!repair && surface.welded_edges == 0) {
    if (surface.open_edges > 0)
      data.notices.push_back(what + ", but welding would not make a manifold: left as they are");
    return;
  }
  if (surface.triangles.empty()) throw Input_error(file + ": all faces are collapsed, no surface is left");
  if (coincident > 0) data.notices.push_back(what + (surface.welded_edges > 0 ? ": welded" : ""));
  for (const std::string& remark : internal::repair_remarks(repaired)) data.notices.push_back(remark);
  for (const std::string& remark : internal::welding_remarks(surface, n)) data.notices.push_back(remark);
  internal::take_surface(std::move(surface), data);
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WELD_ANIMATION_H
