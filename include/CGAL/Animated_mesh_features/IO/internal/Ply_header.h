// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PLY_HEADER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PLY_HEADER_H

#include <CGAL/Animated_mesh_features/IO/internal/Text_scanner.h>
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

enum class Ply_type
{
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  FLOAT32,
  FLOAT64
};

struct Ply_property
{
  std::string name;
  Ply_type type;
  bool is_list;
  Ply_type count_type; // of lists
};

struct Ply_element
{
  std::string name;
  std::size_t count;
  std::vector<Ply_property> properties;
};

struct Ply_header
{
  bool is_binary = false;
  Byte_order order = Byte_order::LITTLE_ENDIAN_ORDER;
  std::vector<Ply_element> elements;
};

inline Ply_type ply_type(Text_scanner& in)
{
  static const struct
  {
    std::string_view name, new_name;
    Ply_type type;
  } types[] = {{"char", "int8", Ply_type::INT8},        {"uchar", "uint8", Ply_type::UINT8},
               {"short", "int16", Ply_type::INT16},     {"ushort", "uint16", Ply_type::UINT16},
               {"int", "int32", Ply_type::INT32},       {"uint", "uint32", Ply_type::UINT32},
               {"float", "float32", Ply_type::FLOAT32}, {"double", "float64", Ply_type::FLOAT64}};
  const std::string_view name = in.token();
  for (const auto& t : types)
    if (name == t.name || name == t.new_name) return t.type;
  in.fail(Text_scanner::quoted(name) + " is no type of a property");
}

inline Ply_header ply_header(Text_scanner& in)
{
  Ply_header header;
  if (in.token() != "ply") in.fail("the file does not start with \"ply\"");
  in.next_line();
  bool has_format = false;
  for (; !in.at_end(); in.next_line()) {
    const std::string_view keyword = in.token();
    if (keyword == "format") {
      const std::string_view format = in.token();
      header.is_binary = format != "ascii";
      if (format == "binary_big_endian") {
        header.order = Byte_order::BIG_ENDIAN_ORDER;
      } else if (format != "ascii" && format != "binary_little_endian") {
        in.fail("unknown format " + Text_scanner::quoted(format));
      }
      has_format = true;
    } else if (keyword == "element") {
      const std::string_view name = in.token();
      const long long count = in.integer("the number of elements");
      if (count < 0) in.fail("the number of elements is negative");
      header.elements.push_back({std::string(name), static_cast<std::size_t>(count), {}});
    } else if (keyword == "property") {
      if (header.elements.empty()) in.fail("a property before the first element");
      Ply_property property = {"", Ply_type::INT8, false, Ply_type::INT8};
      property.is_list = in.accept("list");
      if (property.is_list) property.count_type = ply_type(in);
      property.type = ply_type(in);
      property.name = std::string(in.token());
      header.elements.back().properties.push_back(property);
    } else if (keyword == "end_header") {
      if (!has_format) in.fail("the header names no format");
      in.next_line();
      return header;
    } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
      in.fail("unknown keyword " + Text_scanner::quoted(keyword) + " in the header");
    }
  }
  in.fail("the file ends within the header");
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PLY_HEADER_H
