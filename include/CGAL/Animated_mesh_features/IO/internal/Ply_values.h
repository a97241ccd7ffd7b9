// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PLY_VALUES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PLY_VALUES_H

#include <CGAL/Animated_mesh_features/IO/internal/Ply_header.h>
#include <CGAL/Animated_mesh_features/IO/internal/Text_scanner.h>
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

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

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PLY_VALUES_H
