// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_OFF_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_OFF_H

#include <CGAL/Animated_mesh_features/IO/internal/Mesh_builder.h>
#include <CGAL/Animated_mesh_features/IO/internal/Text_scanner.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

inline std::size_t off_count(Text_scanner& in, const char* what)
{
  in.skip_space();
  const long long n = in.integer(what);
  if (n < 0) in.fail(std::string(what) + " is negative");
  return static_cast<std::size_t>(n);
}

// The letters that stand before OFF, in any order: texture coordinates, colours and normals are three of those forms whose
// vertices begin with three coordinates. All may be in small letters; a single n before OFF means other dimensions.
inline bool is_off_keyword(std::string_view keyword)
{
  std::string word(keyword);
  if (word.size() >= 3 && word.compare(word.size() - 3, 3, "off") == 0)
    for (char& c : word)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  for (std::size_t i = 0; i < word.size();) {
    if (word.compare(i, std::string::npos, "OFF") == 0) return true;
    if (word.compare(i, 2, "ST") == 0)
      i += 2;
    else if (word[i] == 'C' || word[i] == 'N')
      ++i;
    else
      return false;
  }
  return false;
}

// OFF in ASCII with the prefixes ST, C and N; texture coordinates, colours and normals, which stand after the
// position, are skipped with the rest of the line.
//
// CGAL::IO::read_OFF() says neither where nor why it fails, trusts the counts of the header, and reads numbers in the
// global locale.
inline bool parse_off(const std::string& text, const std::string& file, const Mesh_reading_options& options,
                      Indexed_mesh& mesh, const Indexed_mesh* reference = nullptr)
{
  Text_scanner in(text, file, '#');
  Mesh_builder builder(file, options, mesh, reference);
  in.skip_space();
  // the number of vertices may follow without a blank
  const std::string_view keyword = in.token_of([](char c) { return c < '0' || c > '9'; });
  if (!is_off_keyword(keyword))
    in.fail("the file starts with " + Text_scanner::quoted(keyword.empty() ? in.token() : keyword) +
            " instead of OFF, COFF, NOFF or another form with three coordinates");
  if (in.accept("BINARY")) in.fail("binary OFF is not supported; convert it to ASCII, or to PLY");

  const std::size_t points = off_count(in, "the number of vertices");
  const std::size_t faces = off_count(in, "the number of faces");
  in.next_line(); // the number of edges, which nobody needs
  builder.reserve(points, faces, text.size());

  while (builder.number_of_points() < points) {
    in.skip_space();
    if (in.at_end())
      in.fail("the file ends after " + std::to_string(builder.number_of_points()) + " of " + std::to_string(points) +
              " vertices");
    const std::size_t line = in.line();
    const double x = in.number("a coordinate"), y = in.number("a coordinate"), z = in.number("a coordinate");
    builder.add_point(x, y, z, line);
    in.next_line();
  }
  std::vector<std::size_t> corners;
  while (builder.number_of_faces() < faces) {
    in.skip_space();
    if (in.at_end())
      in.fail("the file ends after " + std::to_string(builder.number_of_faces()) + " of " + std::to_string(faces) +
              " faces");
    const std::size_t line = in.line();
    corners.clear();
    for (std::size_t n = off_count(in, "the number of corners"); n > 0; --n) {
      const long long i = in.integer("a vertex");
      if (i < 0) in.fail("face " + std::to_string(builder.number_of_faces()) + " has a negative vertex index");
      corners.push_back(static_cast<std::size_t>(i));
    }
    builder.add_face(corners, line);
    in.next_line();
  }
  in.skip_space();
  if (!in.at_end())
    in.fail("the file goes on after the " + std::to_string(points) + " vertices and " + std::to_string(faces) +
            " faces that its header announces");
  return builder.finish();
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_OFF_H
