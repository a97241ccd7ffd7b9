// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_PLY_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_PLY_H

#include <CGAL/Animated_mesh_features/IO/internal/Mesh_builder.h>
#include <CGAL/Animated_mesh_features/IO/internal/Ply_header.h>
#include <CGAL/Animated_mesh_features/IO/internal/Ply_values.h>
#include <CGAL/Animated_mesh_features/IO/internal/Text_scanner.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Strips of triangles: each corner makes one with the two before it, turned round every second time; -1 begins a new strip.
class Ply_strip
{
public:
  explicit Ply_strip(Mesh_builder& builder)
    : m_builder(builder)
  {}

  void add(double value, std::size_t line, const Ply_values& values)
  {
    if (value == -1) {
      m_corners.clear();
      return;
    }
    m_corners.push_back(values.checked_index(value, "a vertex index"));
    const std::size_t n = m_corners.size();
    if (n < 3) return;
    std::vector<std::size_t> face(m_corners.end() - 3, m_corners.end());
    if (n % 2 == 0) std::swap(face[0], face[1]);
    // strips are joined by triangles that have a vertex twice
    if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) m_builder.add_face(face, line);
  }

private:
  Mesh_builder& m_builder;
  std::vector<std::size_t> m_corners;
};

// What is done with the values of an element of a kind.
class Ply_element_reader
{
public:
  Ply_element_reader(const Ply_element& element, Ply_values& values, Mesh_builder& builder)
    : m_element(element)
    , m_values(values)
    , m_builder(builder)
    , m_is_vertex(element.name == "vertex")
    , m_is_face(element.name == "face")
    , m_is_strips(element.name == "tristrips")
  {
    int coordinates = 0, index_lists = 0;
    for (const Ply_property& p : element.properties) {
      const bool is_coordinate = m_is_vertex && !p.is_list && p.name.size() == 1 && p.name >= "x" && p.name <= "z";
      coordinates += is_coordinate;
      m_is_corners.push_back((m_is_face || m_is_strips) && p.is_list &&
                             (p.name == "vertex_indices" || p.name == "vertex_index"));
      index_lists += m_is_corners.back();
      m_targets.push_back(is_coordinate ? &m_xyz[std::size_t(p.name[0] - 'x')] : &m_ignored);
    }
    if (m_is_vertex && coordinates != 3) builder.fail(0, "the vertices lack a property x, y or z");
    if ((m_is_face || m_is_strips) && index_lists != 1)
      builder.fail(0, std::string(m_is_face ? "the faces" : "the strips of triangles") +
                          " lack a list vertex_indices or vertex_index");
  }

  void read(std::size_t index)
  {
    m_values.start(m_element, index);
    const std::size_t line = m_values.line();
    Ply_strip strip(m_builder);
    for (std::size_t k = 0; k < m_element.properties.size(); ++k) {
      const Ply_property& p = m_element.properties[k];
      if (!p.is_list) {
        *m_targets[k] = m_values.next(p.type);
        continue;
      }
      if (m_is_corners[k]) m_corners.clear();
      for (std::size_t n = m_values.next_length(p); n > 0; --n) {
        if (!m_is_corners[k])
          m_values.next(p.type);
        else if (m_is_strips)
          strip.add(m_values.next(p.type), line, m_values);
        else
          m_corners.push_back(m_values.next_index(p.type, "a vertex index"));
      }
    }
    m_values.finish();
    if (m_is_vertex) m_builder.add_point(m_xyz[0], m_xyz[1], m_xyz[2], line);
    if (m_is_face) m_builder.add_face(m_corners, line);
  }

private:
  const Ply_element& m_element;
  Ply_values& m_values;
  Mesh_builder& m_builder;
  bool m_is_vertex, m_is_face, m_is_strips;
  std::array<double, 3> m_xyz = {{0, 0, 0}};
  double m_ignored = 0;
  std::vector<double*> m_targets; // where the value of each property goes
  std::vector<char> m_is_corners; // whether it is the list of corners
  std::vector<std::size_t> m_corners;
};

// PLY, ASCII and binary: the properties x, y, z of the element `vertex` and the list `vertex_indices` (or
// `vertex_index`) of the elements `face` and `tristrips`, of whatever types; everything else is skipped.
//
// CGAL::IO::read_PLY() says neither where nor why it fails and knows lists of 32-bit indices only.
inline bool parse_ply(const std::string& text, const std::string& file, const Mesh_reading_options& options,
                      Indexed_mesh& mesh, const Indexed_mesh* reference = nullptr)
{
  Text_scanner in(text, file, '\0');
  Mesh_builder builder(file, options, mesh, reference);
  const Ply_header header = ply_header(in);
  Ply_values values(in, header);
  for (const Ply_element& element : header.elements) {
    Ply_element_reader reader(element, values, builder);
    if (element.properties.empty()) continue;
    if (element.name == "vertex") builder.reserve(element.count, 0, text.size());
    if (element.name == "face") builder.reserve(0, element.count, text.size());
    for (std::size_t i = 0; i < element.count; ++i) reader.read(i);
  }
  if (values.only_line_ends_follow() && !values.at_end())
    builder.remark("an end of a line follows the last element, which says nothing");
  else if (!values.at_end())
    builder.fail(values.line(), "the file goes on after all elements that its header announces");
  return builder.finish();
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_PLY_H
