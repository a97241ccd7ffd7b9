// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_CHECK_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_CHECK_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// What must hold in a glTF file; if it does not, the message begins with the file's name.
class Gltf_check
{
public:
  explicit Gltf_check(const std::string& file)
    : m_file(file)
  {}

  [[noreturn]] void fail(const std::string& message) const { throw Input_error(m_file + ": " + message); }

  // The index of one of `size` things, where the file has any whole number.
  std::size_t index(int i, std::size_t size, const std::string& name) const
  {
    if (i < 0 || std::size_t(i) >= size) fail(name + " " + std::to_string(i) + " is not there");
    return std::size_t(i);
  }

private:
  const std::string& m_file;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_CHECK_H
