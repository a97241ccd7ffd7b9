// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_PLY_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_PLY_H

#include <CGAL/Animated_mesh_features/IO/internal/Mesh_builder.h>
#include <CGAL/Animated_mesh_features/IO/internal/Ply_header.h>
#include <CGAL/Animated_mesh_features/IO/internal/Text_scanner.h>
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// The values after the header, one after the other. Every PLY type fits a double exactly.
class Ply_values
{
public:
  Ply_values(Text_scanner& in, const Ply_header& header)
    : m_in(in)
    , m_is_binary(header.is_binary)
    , m_order(header.order)
    , m_p(in.position())
  {}

  // the element to name in messages
  void start(const Ply_element& element, std::size_t index)
  {
    m_element = &element;
    m_index = index;
    m_values = 0;
    m_announced = element.properties.size();
    if (!m_is_binary) m_in.skip_space();
  }

  // In ASCII an element is a line. If values were taken from the next one, or left, all that follow would shift.
  void finish()
  {
    if (m_is_binary || m_in.at_end_of_line()) return;
    std::size_t more = 0;
    while (!m_in.at_end_of_line()) {
      m_in.skip_token();
      ++more;
    }
    fail_for_values(m_values + more, m_values);
  }

  std::size_t line() const { return m_is_binary ? 0 : m_in.line(); }

  double next(Ply_type type)
  {
    if (!m_is_binary) {
      if (m_in.at_end()) fail_at_end();
      if (m_in.at_end_of_line() && !m_in.at_end()) fail_for_values(m_values, m_announced);
      ++m_values;
      return m_in.number("a value");
    }
    switch (type) {
    case Ply_type::INT8:
      return double(take<std::int8_t>());
    case Ply_type::UINT8:
      return double(take<std::uint8_t>());
    case Ply_type::INT16:
      return double(take<std::int16_t>());
    case Ply_type::UINT16:
      return double(take<std::uint16_t>());
    case Ply_type::INT32:
      return double(take<std::int32_t>());
    case Ply_type::UINT32:
      return double(take<std::uint32_t>());
    case Ply_type::FLOAT32:
      return double(take<float>());
    default:
      return double(take<double>());
    }
  }

  // the length of a list, whose values follow
  std::size_t next_length(const Ply_property& property)
  {
    const std::size_t n = next_index(property.count_type, "the length of a list");
    m_announced += n;
    return n;
  }

  // a count or a vertex
  std::size_t next_index(Ply_type type, const char* what)
  {
    if (m_is_binary) { // the integer types
      switch (type) {
      case Ply_type::UINT8:
        return take<std::uint8_t>();
      case Ply_type::UINT16:
        return take<std::uint16_t>();
      case Ply_type::UINT32:
        return take<std::uint32_t>();
      case Ply_type::INT8:
        return checked_index(take<std::int8_t>(), what);
      case Ply_type::INT16:
        return checked_index(take<std::int16_t>(), what);
      case Ply_type::INT32:
        return checked_index(take<std::int32_t>(), what);
      default:
        break;
      }
    }
    return checked_index(next(type), what);
  }

  bool at_end()
  {
    if (m_is_binary) return m_p == m_in.end();
    m_in.skip_space();
    return m_in.at_end();
  }

  // Whether all that is left are ends of lines, such as editors append.
  bool only_line_ends_follow() const
  {
    return m_is_binary && std::all_of(m_p, m_in.end(), [](char c) { return c == '\n' || c == '\r'; });
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    const std::string where = m_element == nullptr ? "" : m_element->name + " " + std::to_string(m_index) + ": ";
    if (!m_is_binary) m_in.fail(where + message);
    throw Input_error(m_in.file() + ": " + where + message);
  }

  template <class Number>
  std::size_t checked_index(Number x, const char* what) const
  {
    const double largest = 4294967295.; // of the largest integer type
    if (!(x >= 0 && double(x) <= largest) || double(x) != double(static_cast<std::size_t>(x)))
      fail(std::string(what) + " is negative, too large or not a whole number");
    return static_cast<std::size_t>(x);
  }

private:
  [[noreturn]] void fail_at_end() const
  {
    fail("the file ends here, its header announces " + std::to_string(m_element->count) + " of them");
  }

  [[noreturn]] void fail_for_values(std::size_t values, std::size_t announced) const
  {
    throw Input_error(m_in.file() + ": line " + std::to_string(m_in.line()) + " has " + std::to_string(values) +
                      (values == 1 ? " value" : " values") + ", the header announces " + std::to_string(announced) +
                      " (" + m_element->name + " " + std::to_string(m_index) + ")");
  }

  template <class T>
  T take()
  {
    if (std::size_t(m_in.end() - m_p) < sizeof(T)) fail_at_end();
    const T value = load<T>(m_p, m_order);
    m_p += sizeof(T);
    return value;
  }

  Text_scanner& m_in;
  bool m_is_binary;
  Byte_order m_order;
  const char* m_p; // of the binary part
  const Ply_element* m_element = nullptr;
  std::size_t m_index = 0;
  std::size_t m_values = 0;    // of the element so far
  std::size_t m_announced = 0; // that it has, as far as is known
};

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
