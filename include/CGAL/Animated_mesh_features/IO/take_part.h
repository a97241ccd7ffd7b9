// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_TAKE_PART_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_TAKE_PART_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/Surface_components.h>
#include <CGAL/Animated_mesh_features/IO/internal/take_surface.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

what parts of the surface of an animation there are to be taken, for messages: the names that the file has, and the
numbers of components with their vertices, of each at most the first `most`.
*/
template <class FT>
std::string part_list(const Animation_file_data<FT>& data, std::size_t most = 20)
{
  const auto others = [&](std::size_t n) {
    return n > most ? " and " + std::to_string(n - most) + " others" : std::string();
  };
  std::string list;
  for (std::size_t i = 0; i < data.part_names.size() && i < most; ++i)
    list += (i > 0 ? ", \"" : "\"") + data.part_names[i] + "\"";
  list += others(data.part_names.size());
  const std::vector<std::size_t> sizes = Surface_components(data.mesh).vertices;
  list += (list.empty() ? "" : "; ") + std::string(sizes.size() == 1 ? "one component, 1 (" : "components 1 (");
  for (std::size_t i = 0; i < sizes.size() && i < most; ++i)
    list +=
        (i > 0 ? ", " + std::to_string(i + 1) + " (" : "") + std::to_string(sizes[i]) + (i > 0 ? ")" : " vertices)");
  return list + others(sizes.size());
}

/*!
\ingroup PkgAnimatedMeshFeaturesReading

keeps of an animation some of its triangles, and the vertices that they have, in their order. `Animation_file_data::origins`
tells which vertices of the file these are. Linear in the size of the animation; memory for one more field meanwhile.

\param data the animation
\param is_kept for each triangle; one of them at least.
*/
template <class FT>
void keep_triangles(const std::vector<char>& is_kept, Animation_file_data<FT>& data)
{
  const std::size_t unused = std::size_t(-1);
  std::vector<std::size_t> vertex(data.mesh.points.size(), unused); // of the part
  for (std::size_t i = 0; i < is_kept.size(); ++i)
    if (is_kept[i])
      for (std::size_t v : data.mesh.triangles[i]) vertex[v] = 0;
  Welded_surface part;
  for (std::size_t v = 0; v < vertex.size(); ++v) {
    if (vertex[v] == unused) continue;
    vertex[v] = part.file_vertices.size();
    part.first.push_back(vertex[v]);
    part.file_vertices.push_back(v);
  }
  part.first.push_back(part.file_vertices.size());
  for (std::size_t i = 0; i < is_kept.size(); ++i) {
    const auto& t = data.mesh.triangles[i];
    if (is_kept[i]) part.triangles.push_back({{vertex[t[0]], vertex[t[1]], vertex[t[2]]}});
  }
  internal::take_surface(std::move(part), data);
}

/*!
\ingroup PkgAnimatedMeshFeaturesReading

keeps of an animation the triangles that an OBJ file gives a name to (`Indexed_mesh::groups`), and notes the names of all
(`Animation_file_data::part_names`).

\return whether there is such a name; otherwise nothing is left out.
*/
template <class FT>
bool keep_group(const std::string& name, Animation_file_data<FT>& data)
{
  std::vector<char> is_kept(data.mesh.triangles.size(), 0);
  std::set<std::string> known;
  const std::vector<Indexed_mesh::Group>& groups = data.mesh.groups;
  bool is_found = false;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::size_t first = groups[g].first_triangle,
                      last = g + 1 < groups.size() ? groups[g + 1].first_triangle : is_kept.size();
    if (first == last) continue; // the name of points only
    for (const std::string& n : groups[g].names) {
      if (known.insert(n).second) data.part_names.push_back(n);
      if (n != name) continue;
      is_found = true;
      std::fill(is_kept.begin() + std::ptrdiff_t(first), is_kept.begin() + std::ptrdiff_t(last), 1);
    }
  }
  if (is_found) keep_triangles(is_kept, data);
  return is_found;
}

/*!
\ingroup PkgAnimatedMeshFeaturesReading

keeps of an animation the connected component with the given number, counted from 1 in the order of `Surface_components`.

\throws Option_error if there is no such component; the message lists all parts there are.
*/
template <class FT>
void keep_component(const std::string& number, Animation_file_data<FT>& data)
{
  const Surface_components components(data.mesh);
  for (std::size_t c = 0; c < components.vertices.size(); ++c) {
    if (std::to_string(c + 1) != number) continue;
    std::vector<char> is_kept;
    for (std::size_t of : components.of_triangle) is_kept.push_back(of == c);
    keep_triangles(is_kept, data);
    return;
  }
  throw Option_error(data.sources.front() + ": there is no part \"" + number + "\"; parts are " + part_list(data));
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_TAKE_PART_H
