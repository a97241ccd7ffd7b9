// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_MESH_BUILDER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_MESH_BUILDER_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/Mesh_reading_options.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// What the readers of all formats have in common: it collects points and faces and refuses what is no triangle mesh.
// `line` is 0 where a file has no lines. Vertices and faces are counted from 0, as everywhere in the package.
//
// With `reference`, triangles are not collected as long as they are those of another mesh, in its order: all frames of
// an animation have the same. See finish(), whose result all readers return.
class Mesh_builder
{
public:
  Mesh_builder(const std::string& file, const Mesh_reading_options& options, Indexed_mesh& mesh,
               const Indexed_mesh* reference)
    : m_file(file)
    , m_options(options)
    , m_mesh(mesh)
    , m_reference(reference)
  {
    m_mesh.points.clear();
    m_mesh.triangles.clear();
    m_mesh.remarks.clear();
    m_mesh.groups.clear();
  }

  void remark(const std::string& sentence) { m_mesh.remarks.push_back(sentence); }

  // The faces that follow are called so. Of frames that have the faces of a reference, nobody asks.
  void begin_group(const std::vector<std::string>& names)
  {
    if (m_reference != nullptr) return;
    std::vector<Indexed_mesh::Group>& groups = m_mesh.groups;
    if (!groups.empty() && groups.back().first_triangle == m_mesh.triangles.size())
      groups.back().names = names;
    else
      groups.push_back({names, m_mesh.triangles.size()});
  }

  // `bytes`: the size of the file, so that a nonsensical header does not ask for all memory
  void reserve(std::size_t points, std::size_t faces, std::size_t bytes)
  {
    const std::size_t least_bytes = 6; // "0 0 0\n"
    m_mesh.points.reserve((std::min)(points, bytes / least_bytes));
    if (m_reference == nullptr) m_mesh.triangles.reserve((std::min)(faces, bytes / least_bytes));
  }

  std::size_t number_of_points() const { return m_mesh.points.size(); }
  std::size_t number_of_faces() const { return m_faces; }

  void add_point(double x, double y, double z, std::size_t line)
  {
    if (!is_finite(x) || !is_finite(y) || !is_finite(z))
      fail(line, "vertex " + std::to_string(number_of_points()) + " has a coordinate that is not finite");
    m_mesh.points.push_back({{x, y, z}});
  }

  void add_face(const std::vector<std::size_t>& corners, std::size_t line)
  {
    const std::size_t n = corners.size();
    if (n < 3)
      fail(line, "face " + std::to_string(m_faces) + " has " + std::to_string(n) +
                     (n == 1 ? " corner only" : " corners only"));
    if (n > 3 && !m_options.triangulate_faces)
      fail(line, "face " + std::to_string(m_faces) + " has " + std::to_string(n) +
                     " corners; the mesh must consist of triangles, or be read with the option triangulate_faces "
                     "(command line: --triangulate)");
    // Corners may come before their points. The first one too large for the whole file is among those that exceed
    // all before them.
    for (std::size_t c : corners)
      if (c >= number_of_points() && (m_references.empty() || c > m_references.back().vertex))
        m_references.push_back({c, m_faces, line});
    for (std::size_t i = 2; i < n; ++i) add_triangle({{corners[0], corners[i - 1], corners[i]}});
    ++m_faces;
  }

  // To be called at the end of the file. Returns whether the triangles are those of the reference; if so, the mesh has
  // points only.
  bool finish()
  {
    if (m_mesh.points.empty()) fail(0, "holds no vertices");
    for (const Reference& r : m_references)
      if (r.vertex >= number_of_points())
        fail(r.line, "face " + std::to_string(r.face) + " has a corner at vertex " + std::to_string(r.vertex) +
                         " (counted from 0), the mesh has " + std::to_string(number_of_points()) + " vertices");
    if (m_same_triangles == 0 && m_mesh.triangles.empty()) fail(0, "holds no faces");
    if (m_reference != nullptr && m_same_triangles == m_reference->triangles.size()) return true;
    stop_comparing();
    return false;
  }

  [[noreturn]] void fail(std::size_t line, const std::string& message) const
  {
    throw Input_error(m_file + (line != 0 ? ":" + std::to_string(line) + ": " : ": ") + message);
  }

private:
  struct Reference
  {
    std::size_t vertex, face, line;
  };

  void add_triangle(const std::array<std::size_t, 3>& triangle)
  {
    if (m_reference != nullptr) {
      if (m_same_triangles < m_reference->triangles.size()) {
        const std::array<std::size_t, 3>& other = m_reference->triangles[m_same_triangles];
        if (triangle[0] == other[0] && triangle[1] == other[1] && triangle[2] == other[2]) {
          ++m_same_triangles;
          return;
        }
      }
      stop_comparing();
    }
    m_mesh.triangles.push_back(triangle);
  }

  void stop_comparing()
  {
    if (m_reference == nullptr) return;
    const auto begin = m_reference->triangles.begin();
    m_mesh.triangles.assign(begin, begin + std::ptrdiff_t(m_same_triangles));
    m_reference = nullptr;
  }

  const std::string& m_file;
  const Mesh_reading_options& m_options;
  Indexed_mesh& m_mesh;
  const Indexed_mesh* m_reference; // null if there is none, or none any more
  std::size_t m_same_triangles = 0;
  std::size_t m_faces = 0;
  std::vector<Reference> m_references;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_MESH_BUILDER_H
