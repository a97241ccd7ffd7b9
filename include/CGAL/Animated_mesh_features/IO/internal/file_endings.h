// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FILE_ENDINGS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FILE_ENDINGS_H

#include <cstddef>
#include <filesystem>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// ".obj" of "Walk.OBJ"; letters of ASCII only, so that the locale has no say.
inline std::string ending(const std::string& path)
{
  std::string e = std::filesystem::path(path).extension().string();
  for (char& c : e)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return e;
}

inline bool is_mesh_ending(const std::string& e)
{
  return e == ".obj" || e == ".off" || e == ".ply" || e == ".stl";
}

inline bool is_cache_ending(const std::string& e)
{
  return e == ".pc2" || e == ".mdd";
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FILE_ENDINGS_H
