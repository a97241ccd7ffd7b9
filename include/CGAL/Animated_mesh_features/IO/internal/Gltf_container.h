// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_CONTAINER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_CONTAINER_H

#include <CGAL/Animated_mesh_features/IO/internal/Gltf_check.h>
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// What a file of glTF consists of: its JSON text and, in a .glb, the binary data after it.
struct Gltf_container
{
  std::string text;
  std::optional<std::string> binary;
};

// Takes a file apart: all of it is text, or it is made of chunks with a size and a kind each, of which those of other kinds
// are passed over (glTF 2.0, section 4.4).
inline Gltf_container gltf_container(std::string content, const Gltf_check& check)
{
  Gltf_container result;
  if (content.compare(0, 4, "glTF") != 0) {
    result.text = std::move(content);
    return result;
  }
  const auto number = [&](std::size_t at) {
    return load<std::uint32_t>(&content[at], Byte_order::LITTLE_ENDIAN_ORDER);
  };
  const std::size_t file_header = 12, chunk_header = 8;
  const std::uint32_t json = 0x4e4f534a, binary = 0x004e4942; // "JSON" and "BIN"
  if (content.size() < file_header + chunk_header) check.fail("is no readable glTF 2.0: it ends in its header");
  if (number(4) != 2) check.fail("is binary glTF " + std::to_string(number(4)) + ", not glTF 2.0");
  const std::size_t size = number(8);
  if (size > content.size())
    check.fail("is no readable glTF 2.0: it has " + std::to_string(content.size()) + " bytes, its header announces " +
               std::to_string(size));
  for (std::size_t at = file_header; at + chunk_header <= size;) {
    const std::size_t length = number(at), kind = number(at + 4);
    const bool is_first = at == file_header;
    at += chunk_header;
    if (length > size - at)
      check.fail("is no readable glTF 2.0: a chunk of " + std::to_string(length) + " bytes exceeds it");
    if (is_first != (kind == json)) check.fail("is no readable glTF 2.0: its first chunk, and no other, holds JSON");
    if (kind == json) result.text = content.substr(at, length);
    if (kind == binary && !result.binary) result.binary = content.substr(at, length);
    at += length;
  }
  return result;
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_CONTAINER_H
