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

#include <cstddef>
#include <cstdint>
#include <string>
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
    if (!m_is_binary) m_in.skip_space();
  }

  std::size_t line() const { return m_is_binary ? 0 : m_in.line(); }

  double next(Ply_type type)
  {
    if (!m_is_binary) {
      m_in.skip_space();
      if (m_in.at_end()) fail_at_end();
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

  [[noreturn]] void fail(const std::string& message) const
  {
    const std::string where = m_element == nullptr ? "" : m_element->name + " " + std::to_string(m_index) + ": ";
    if (!m_is_binary) m_in.fail(where + message);
    throw Input_error(m_in.file() + ": " + where + message);
  }

private:
  template <class Number>
  std::size_t checked_index(Number x, const char* what) const
  {
    const double largest = 4294967295.; // of the largest integer type
    if (!(x >= 0 && double(x) <= largest) || double(x) != double(static_cast<std::size_t>(x)))
      fail(std::string(what) + " is negative, too large or not a whole number");
    return static_cast<std::size_t>(x);
  }

  [[noreturn]] void fail_at_end() const
  {
    fail("the file ends here, its header announces " + std::to_string(m_element->count) + " of them");
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
};

// PLY, ASCII and binary: the properties x, y, z of the element `vertex` and the list `vertex_indices` (or
// `vertex_index`) of the element `face`, of whatever types; everything else is skipped.
//
// CGAL::IO::read_PLY() says neither where nor why it fails and knows lists of 32-bit indices only.
inline bool parse_ply(const std::string& text, const std::string& file, const Mesh_reading_options& options,
                      Indexed_mesh& mesh, const Indexed_mesh* reference = nullptr)
{
  Text_scanner in(text, file, '\0');
  Mesh_builder builder(file, options, mesh, reference);
  const Ply_header header = ply_header(in);
  Ply_values values(in, header);

  std::vector<std::size_t> corners;
  for (const Ply_element& element : header.elements) {
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
    double xyz[3] = {0, 0, 0}, ignored = 0;
    std::vector<double*> targets; // where the value of each property goes
    std::vector<char> is_corners; // whether it is the list of corners
    int coordinates = 0, index_lists = 0;
    for (const Ply_property& p : element.properties) {
      const bool is_coordinate = is_vertex && !p.is_list && p.name.size() == 1 && p.name >= "x" && p.name <= "z";
      coordinates += is_coordinate;
      is_corners.push_back(is_face && p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index"));
      index_lists += is_corners.back();
      targets.push_back(is_coordinate ? &xyz[p.name[0] - 'x'] : &ignored);
    }
    if (is_vertex && coordinates != 3) builder.fail(0, "the vertices lack a property x, y or z");
    if (is_face && index_lists != 1) builder.fail(0, "the faces lack a list vertex_indices or vertex_index");
    if (element.properties.empty()) continue;
    if (is_vertex) builder.reserve(element.count, 0, text.size());
    if (is_face) builder.reserve(0, element.count, text.size());

    for (std::size_t i = 0; i < element.count; ++i) {
      values.start(element, i);
      const std::size_t line = values.line();
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const Ply_property& p = element.properties[k];
        if (!p.is_list) {
          *targets[k] = values.next(p.type);
          continue;
        }
        if (is_corners[k]) corners.clear();
        for (std::size_t n = values.next_index(p.count_type, "the length of a list"); n > 0; --n) {
          if (is_corners[k]) {
            corners.push_back(values.next_index(p.type, "a vertex index"));
          } else {
            values.next(p.type);
          }
        }
      }
      if (is_vertex) builder.add_point(xyz[0], xyz[1], xyz[2], line);
      if (is_face) builder.add_face(corners, line);
    }
  }
  if (!values.at_end()) builder.fail(values.line(), "the file goes on after all elements that its header announces");
  return builder.finish();
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_PLY_H
