// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_OBJ_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_OBJ_H

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

// The names of an object, whose name is the rest of its line, and of the groups in it.
struct Obj_names
{
  std::string object;
  std::vector<std::string> groups;

  // after the statement `o`, or `g`
  void read(bool is_object, Text_scanner& in)
  {
    groups.clear();
    if (is_object) object.clear();
    while (!in.at_end_of_line()) {
      const std::string word(in.token());
      if (word.empty()) break;
      if (is_object)
        object += (object.empty() ? "" : " ") + word;
      else
        groups.push_back(word);
    }
  }

  std::vector<std::string> all() const
  {
    std::vector<std::string> names = groups;
    if (!object.empty()) names.insert(names.begin(), object);
    return names;
  }
};

// Wavefront OBJ: the statements `v` and `f`, and the names of objects and groups of faces, `o` and `g`; all others (normals,
// texture coordinates, materials, lines, free forms) say nothing about the surface and are skipped.
inline bool parse_obj(const std::string& text, const std::string& file, const Mesh_reading_options& options,
                      Indexed_mesh& mesh, const Indexed_mesh* reference = nullptr)
{
  Text_scanner in(text, file, '#', true);
  Mesh_builder builder(file, options, mesh, reference);
  std::vector<std::size_t> corners;
  Obj_names names;
  for (; !in.at_end(); in.next_line()) {
    const std::string_view statement = in.token();
    const bool is_one_letter = statement.size() == 1; // most lines: comparing letters is faster than comparing words
    if (is_one_letter && statement[0] == 'v') {
      const double x = in.number("a coordinate"), y = in.number("a coordinate"), z = in.number("a coordinate");
      // a weight or a colour may follow
      builder.add_point(x, y, z, in.line());
    } else if ((is_one_letter && statement[0] == 'f') || statement == "fo") { // the second is the first's old name
      corners.clear();
      while (!in.at_end_of_line()) {
        const long long i = in.integer("a vertex", '/');
        const long long points = static_cast<long long>(builder.number_of_points());
        if (i == 0 || i < -points)
          in.fail("face " + std::to_string(builder.number_of_faces()) + " has the vertex index " + std::to_string(i) +
                  (i == 0 ? ", OBJ counts from 1" : ", there are " + std::to_string(points) + " vertices before it"));
        corners.push_back(static_cast<std::size_t>(i > 0 ? i - 1 : points + i));
      }
      builder.add_face(corners, in.line());
    } else if (is_one_letter && (statement[0] == 'o' || statement[0] == 'g')) {
      names.read(statement[0] == 'o', in);
      builder.begin_group(names.all());
    }
  }
  return builder.finish();
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_OBJ_H
