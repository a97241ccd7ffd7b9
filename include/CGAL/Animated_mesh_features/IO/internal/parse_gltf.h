// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_GLTF_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_GLTF_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>

#include <tiny_gltf.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <limits>
#include <new>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// tinygltf would decode the images, which nobody looks at.
inline bool ignore_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                         void*)
{
  return true;
}

inline std::string one_line(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

// tinygltf fails by returning false, with a reason; but by exceptions of others where what a file refers to is not there.
template <class Parse>
void run_tinygltf(const Parse& parse, const std::string& file)
{
  std::string error;
  bool is_read = false;
  try {
    is_read = parse(error);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    error = "something that it refers to is not there, or is of another kind";
  }
  if (!is_read) throw Input_error(file + ": is no readable glTF 2.0: " + one_line(error));
}

inline void parse_gltf(const std::string& file, tinygltf::Model& model)
{
  std::string content;
  read_content(file, content);
  if (content.size() > (std::numeric_limits<unsigned int>::max)()) throw Input_error(file + ": is larger than 4 GB");
  const unsigned int size = static_cast<unsigned int>(content.size());
  const std::string folder = std::filesystem::path(file).parent_path().string();
  tinygltf::TinyGLTF parser;
  parser.SetImageLoader(ignore_image, nullptr);
  std::string warning;
  const auto parse = [&](std::string& error) {
    if (content.compare(0, 4, "glTF") != 0)
      return parser.LoadASCIIFromString(&model, &error, &warning, content.data(), size, folder);
    const auto* const bytes = reinterpret_cast<const unsigned char*>(content.data());
    return parser.LoadBinaryFromMemory(&model, &error, &warning, bytes, size, folder);
  };
  run_tinygltf(parse, file);
  if (model.asset.version.compare(0, 1, "2") != 0)
    throw Input_error(file + ": is glTF " + model.asset.version + ", not glTF 2.0");
  // Those that change what a triangle or an animation is are not known here; those of materials change nothing.
  for (const std::string& extension : model.extensionsRequired) {
    bool is_harmless = extension == "KHR_mesh_quantization" || extension == "KHR_lights_punctual";
    for (const char* kind : {"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_"})
      is_harmless = is_harmless || extension.compare(0, std::string(kind).size(), kind) == 0;
    if (!is_harmless) throw Input_error(file + ": needs the extension " + extension + ", which is not supported");
  }
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_GLTF_H
