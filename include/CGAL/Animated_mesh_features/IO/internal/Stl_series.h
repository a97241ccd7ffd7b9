// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_STL_SERIES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_STL_SERIES_H

#include <CGAL/Animated_mesh_features/IO/Coincident_vertices.h>
#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/Mesh_reading_options.h>
#include <CGAL/Animated_mesh_features/IO/check_same_connectivity.h>
#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>
#include <CGAL/Animated_mesh_features/IO/internal/parse_stl.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// STL names no vertices. In one file, corners at the same place are taken as one; in a series of files only those that are
// together in all of them, so that vertices may meet in some frames. This reads each file once to find out which they are.
class Stl_series
{
public:
  Stl_series(const std::vector<std::string>& files, const Mesh_reading_options& options)
    : m_options(options)
  {
    std::string content;
    Indexed_mesh corners;
    read_corners(files[0], content, corners);
    m_points_of_file = corners.points.size();
    Coincident_vertices coincident(m_points_of_file);
    m_first_file = files[0];
    m_mesh.triangles = corners.triangles;
    coincident.add_frame(corners.points);
    std::vector<std::array<double, 3>> first_points = corners.points;
    for (std::size_t f = 1; f < files.size(); ++f) {
      read_corners(files[f], content, corners);
      check(corners, files[f]);
      coincident.add_frame(corners.points);
    }
    number_vertices(coincident.first_of_class(), first_points);
  }

  // the vertices of the series, in the order of their first use, where they are in the first file
  const Indexed_mesh& mesh() const { return m_mesh; }

  // The positions of the vertices in a file, which may have changed meanwhile.
  void read_points(const std::string& file, std::string& content, Indexed_mesh& mesh) const
  {
    read_corners(file, content, mesh);
    if (mesh.points.size() != m_points_of_file) throw Input_error(file + ": changed while it was read");
    for (std::size_t v = 0; v < m_corner.size(); ++v) mesh.points[v] = mesh.points[m_corner[v]]; // ascending
    mesh.points.resize(m_corner.size());
  }

private:
  void read_corners(const std::string& file, std::string& content, Indexed_mesh& corners) const
  {
    read_content(file, content);
    if (content.empty()) throw Input_error(file + ": is empty");
    parse_stl(content, file, m_options, corners, nullptr, Stl_corners::APART);
  }

  void check(const Indexed_mesh& corners, const std::string& file) const
  {
    const std::size_t n = m_mesh.triangles.size(), m = corners.triangles.size();
    if (n != m)
      throw Input_error(file + ": has " + std::to_string(m) + " triangles, but the first frame, " + m_first_file +
                        ", has " + std::to_string(n) + "; the connectivity must be the same");
    if (corners.triangles != m_mesh.triangles) // faces with more corners
      check_same_connectivity(m_mesh, m_first_file, corners, file);
  }

  void number_vertices(const std::vector<std::size_t>& first_of_class,
                       const std::vector<std::array<double, 3>>& first_points)
  {
    std::vector<std::size_t> vertex(first_of_class.size());
    for (std::size_t c = 0; c < first_of_class.size(); ++c) {
      if (first_of_class[c] != c) {
        vertex[c] = vertex[first_of_class[c]];
        continue;
      }
      vertex[c] = m_corner.size();
      m_corner.push_back(c);
      m_mesh.points.push_back(first_points[c]);
    }
    for (std::array<std::size_t, 3>& t : m_mesh.triangles)
      for (std::size_t& v : t) v = vertex[v];
  }

  Mesh_reading_options m_options;
  std::string m_first_file;
  std::size_t m_points_of_file = 0; // as many as corners
  Indexed_mesh m_mesh;
  std::vector<std::size_t> m_corner; // the first of each vertex
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_STL_SERIES_H
