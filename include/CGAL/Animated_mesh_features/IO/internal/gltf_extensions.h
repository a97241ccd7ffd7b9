// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_EXTENSIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_EXTENSIONS_H

#include <CGAL/Animated_mesh_features/IO/internal/Gltf_check.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

inline bool is_compression(const std::string& extension)
{
  return extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression" ||
         extension == "KHR_meshopt_compression";
}

// "; it needs EXT_meshopt_compression, ..." of what has no data but that of an extension; or nothing.
inline std::string compression_of(const nlohmann::json& object)
{
  if (!object.is_object() || !object.contains("extensions") || !object["extensions"].is_object()) return std::string();
  for (const auto& extension : object["extensions"].items())
    if (is_compression(extension.key()))
      return "; it needs " + extension.key() + ", which is not supported: export the model without compression";
  return std::string();
}

// Extensions that change what a triangle or an animation is are not known here; those of materials change nothing.
inline void check_required(const std::string& extension, const Gltf_check& check)
{
  if (is_compression(extension))
    check.fail("needs " + extension + ", which is not supported: export the model without compression");
  bool is_harmless = extension == "KHR_mesh_quantization" || extension == "KHR_lights_punctual";
  for (const char* kind : {"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_"})
    is_harmless = is_harmless || extension.compare(0, std::string(kind).size(), kind) == 0;
  if (!is_harmless) check.fail("needs the extension " + extension + ", which is not supported");
}

inline const nlohmann::json& array_in(const nlohmann::json& object, const char* name)
{
  static const nlohmann::json none = nlohmann::json::array();
  return object.is_object() && object.contains(name) && object[name].is_array() ? object[name] : none;
}

// throws Input_error by the name of an extension that it takes to read the file: one that is required, or compresses a
// primitive of which nothing else is there, whether it is said to be required or not.
inline void check_extensions(const nlohmann::json& gltf, const Gltf_check& check)
{
  for (const nlohmann::json& extension : array_in(gltf, "extensionsRequired"))
    if (extension.is_string()) check_required(extension.get<std::string>(), check);
  const nlohmann::json& accessors = array_in(gltf, "accessors");
  for (const nlohmann::json& mesh : array_in(gltf, "meshes"))
    for (const nlohmann::json& primitive : array_in(mesh, "primitives")) {
      const std::string compression = compression_of(primitive);
      if (compression.empty() || !primitive.contains("attributes") || !primitive["attributes"].is_object()) continue;
      const nlohmann::json position = primitive["attributes"].value("POSITION", nlohmann::json());
      if (position.is_number_unsigned() && position < accessors.size() &&
          !accessors[position.get<std::size_t>()].contains("bufferView"))
        check.fail("a primitive has no data" + compression);
    }
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_EXTENSIONS_H
