// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_STL_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_STL_H

#include <CGAL/Animated_mesh_features/IO/internal/Mesh_builder.h>
#include <CGAL/Animated_mesh_features/IO/internal/Text_scanner.h>
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// STL repeats a vertex in each of its triangles.
enum class Stl_corners
{
  BY_PLACE, // equal coordinates are the same vertex, numbered as they come
  APART     // each corner is a vertex
};

class Stl_vertices
{
public:
  Stl_vertices(Mesh_builder& builder, Stl_corners corners)
    : m_builder(builder)
    , m_corners(corners)
  {}

  std::size_t operator()(double x, double y, double z, std::size_t line)
  {
    const std::size_t next = m_builder.number_of_points();
    if (m_corners == Stl_corners::APART) {
      m_builder.add_point(x, y, z, line);
      return next;
    }
    // -0 and 0 are equal, to boost::hash too
    const auto inserted = m_ids.emplace(std::array<double, 3>{{x, y, z}}, next);
    if (inserted.second) m_builder.add_point(x, y, z, line);
    return inserted.first->second;
  }

private:
  Mesh_builder& m_builder;
  Stl_corners m_corners;
  std::unordered_map<std::array<double, 3>, std::size_t, boost::hash<std::array<double, 3>>> m_ids;
};

// The next word; keywords are written in either case of letters.
inline std::string_view stl_word(Text_scanner& in)
{
  in.skip_space();
  const std::string_view word = in.token();
  for (std::string_view keyword : {"solid", "endsolid", "facet", "endfacet", "outer", "loop", "endloop", "vertex"})
    if (equal_but_for_case(word, keyword)) return keyword;
  return word;
}

inline void stl_expect(Text_scanner& in, std::string_view word)
{
  in.skip_space();
  if (in.at_end()) in.fail("the file ends where " + Text_scanner::quoted(word) + " should follow");
  const std::string_view found = stl_word(in);
  if (found != word) in.fail(Text_scanner::quoted(found) + " where " + Text_scanner::quoted(word) + " should follow");
}

inline void parse_ascii_stl(const std::string& text, const std::string& file, Mesh_builder& builder,
                            Stl_vertices& vertices)
{
  Text_scanner in(text, file, '\0');
  std::vector<std::size_t> corners;
  while (in.skip_space(), !in.at_end()) {
    stl_expect(in, "solid");
    in.next_line(); // its name
    for (std::string_view word = stl_word(in); word != "endsolid"; word = stl_word(in)) {
      if (word.empty())
        in.fail("the file ends within a solid, after face " + std::to_string(builder.number_of_faces()));
      if (word != "facet") in.fail(Text_scanner::quoted(word) + " where \"facet\" or \"endsolid\" should follow");
      const std::size_t line = in.line();
      in.next_line(); // its normal
      stl_expect(in, "outer");
      stl_expect(in, "loop");
      corners.clear();
      for (word = stl_word(in); word == "vertex"; word = stl_word(in)) {
        const double x = in.number("a coordinate"), y = in.number("a coordinate"), z = in.number("a coordinate");
        corners.push_back(vertices(x, y, z, in.line()));
      }
      if (word.empty()) in.fail("the file ends within face " + std::to_string(builder.number_of_faces()));
      if (word != "endloop") in.fail(Text_scanner::quoted(word) + " where \"vertex\" or \"endloop\" should follow");
      stl_expect(in, "endfacet");
      builder.add_face(corners, line);
    }
    in.next_line(); // its name again
  }
}

inline void parse_binary_stl(const std::string& bytes, Mesh_builder& builder, Stl_vertices& vertices,
                             std::size_t triangles)
{
  const std::size_t header_size = 84, triangle_size = 50, normal_size = 12, point_size = 12;
  const Byte_order order = Byte_order::LITTLE_ENDIAN_ORDER;
  std::vector<std::size_t> corners(3);
  for (std::size_t t = 0; t < triangles; ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const char* p = bytes.data() + header_size + t * triangle_size + normal_size + c * point_size;
      corners[c] = vertices(load<float>(p, order), load<float>(p + 4, order), load<float>(p + 8, order), 0);
    }
    builder.add_face(corners, 0);
  }
}

// STL, ASCII and binary. A file is binary if its size is what the number of triangles in its header asks for (many
// binary ones start with "solid" as well), ASCII if it starts with "solid" otherwise, in either case of letters.
inline bool parse_stl(const std::string& content, const std::string& file, const Mesh_reading_options& options,
                      Indexed_mesh& mesh, const Indexed_mesh* reference = nullptr,
                      Stl_corners corners = Stl_corners::BY_PLACE)
{
  Mesh_builder builder(file, options, mesh, reference);
  Stl_vertices vertices(builder, corners);
  const std::size_t header_size = 84, triangle_size = 50;
  const bool has_header = content.size() >= header_size;
  const std::uint64_t triangles =
      has_header ? load<std::uint32_t>(content.data() + header_size - 4, Byte_order::LITTLE_ENDIAN_ORDER) : 0;
  const std::uint64_t expected = header_size + triangles * triangle_size;
  if (has_header && expected == content.size()) {
    parse_binary_stl(content, builder, vertices, static_cast<std::size_t>(triangles));
  } else {
    const std::size_t start = content.find_first_not_of(" \t\r\n");
    if (start == std::string::npos) builder.fail(0, "is empty");
    if (equal_but_for_case(std::string_view(content).substr(start, 5), "solid")) {
      parse_ascii_stl(content, file, builder, vertices);
    } else if (!has_header) {
      builder.fail(0, "is neither ASCII STL (no \"solid\") nor binary STL (less than 84 bytes)");
    } else {
      builder.fail(0, "binary STL of " + std::to_string(triangles) + " triangles takes " + std::to_string(expected) +
                          " bytes, the file has " + std::to_string(content.size()));
    }
  }
  return builder.finish();
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_STL_H
