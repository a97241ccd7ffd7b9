// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CHECK_NESTING_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CHECK_NESTING_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Counts how deep the brackets of a JSON text are nested, before any parser sees them: most of them call themselves for each
// level, and some tens of thousands of brackets are the end of the stack.
// throws Input_error if there are more than 64 levels; what is no JSON passes.
inline void check_nesting(const std::string& text, const std::string& file)
{
  constexpr std::size_t most_levels = 64; // files of features have 5, models some 10
  std::size_t depth = 0;
  bool is_in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_in_string) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        is_in_string = false;
    } else if (c == '"') {
      is_in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > most_levels) throw Input_error(file + ": is nested too deeply");
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CHECK_NESTING_H
