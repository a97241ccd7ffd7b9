// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Model_file.h"

#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>
#include <CGAL/Animated_mesh_features/IO/internal/file_endings.h>
#include <CGAL/Animated_mesh_features/IO/sample_clip.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
  #include <CGAL/Animated_mesh_features/IO/read_gltf.h>
#endif
#ifdef ANIMATED_MESH_FEATURES_WITH_ASSIMP
  #include <CGAL/Animated_mesh_features/IO/read_assimp.h>
#endif
#ifdef ANIMATED_MESH_FEATURES_WITH_HDF5
  #include <CGAL/Animated_mesh_features/IO/read_hdf5.h>
#endif

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>

namespace AMF = CGAL::Animated_mesh_features;

namespace Detect_features {

namespace {

Model_format format_by_ending(const std::string& path)
{
  const std::map<std::string, Model_format> formats = {{".glb", Model_format::GLTF},   {".gltf", Model_format::GLTF},
                                                       {".fbx", Model_format::ASSIMP}, {".dae", Model_format::ASSIMP},
                                                       {".x", Model_format::ASSIMP},   {".h5", Model_format::HDF5},
                                                       {".hdf5", Model_format::HDF5}};
  const auto found = formats.find(AMF::IO::internal::ending(path));
  return found == formats.end() ? Model_format::NONE : found->second;
}

Model_format format_by_content(const std::string& path)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return Model_format::NONE;
  std::array<char, 18> bytes{};
  const auto file = AMF::IO::internal::open_for_reading(path);
  const std::string start(bytes.data(), AMF::IO::internal::read_bytes(file.get(), bytes.data(), bytes.size(), path));
  const auto starts_with = [&](const std::string& text) { return start.compare(0, text.size(), text) == 0; };
  if (starts_with("glTF")) return Model_format::GLTF;
  if (starts_with("\x89HDF\r\n\x1a\n")) return Model_format::HDF5;
  if (starts_with("Kaydara FBX Binary")) return Model_format::ASSIMP;
  return Model_format::NONE;
}

AMF::IO::Clip_sampling sampling(const Command_line& c)
{
  AMF::IO::Clip_sampling s;
  s.clip = c.clip;
  s.frames = c.clip_frames;
  s.frames_per_second = c.frames_per_second;
  s.there_and_back = c.there_and_back;
  return s;
}

[[noreturn, maybe_unused]] void throw_without(const std::string& file, const std::string& library,
                                              const std::string& option)
{
  throw AMF::Input_error(file + ": this detect_features was built without " + library +
                         ", which reads such files (CMake option ANIMATED_MESH_FEATURES_WITH_" + option + ")");
}

} // namespace

Model_format model_format(const std::vector<std::string>& inputs)
{
  for (const std::string& input : inputs) {
    const Model_format by_ending = format_by_ending(input);
    const bool is_known = AMF::IO::internal::is_mesh_ending(AMF::IO::internal::ending(input)) ||
                          AMF::IO::internal::is_cache_ending(AMF::IO::internal::ending(input));
    const Model_format format = by_ending != Model_format::NONE || is_known ? by_ending : format_by_content(input);
    if (format == Model_format::NONE) continue;
    if (inputs.size() > 1) throw AMF::Input_error(input + ": an animated model must be the only input");
    return format;
  }
  return Model_format::NONE;
}

AMF::IO::Animation_file_data<double> read_model_file(const Command_line& c, Model_format format,
                                                     const AMF::IO::Memory_chooser& choose_memory)
{
  const std::string& file = c.inputs.front();
  AMF::IO::internal::open_for_reading(file); // says by itself what is wrong with it
  if (format == Model_format::GLTF) {
#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
    return AMF::IO::sample_clip<double>(AMF::IO::read_gltf(file), sampling(c), file, choose_memory);
#else
    throw_without(file, "tinygltf", "GLTF");
#endif
  }
  if (format == Model_format::ASSIMP) {
#ifdef ANIMATED_MESH_FEATURES_WITH_ASSIMP
    AMF::IO::Animation_file_data<double> data =
        AMF::IO::sample_clip<double>(AMF::IO::read_assimp(file), sampling(c), file, choose_memory);
    data.remarks.insert(data.remarks.begin(), "read through assimp, best effort: compare with what you expect");
    return data;
#else
    throw_without(file, "assimp", "ASSIMP");
#endif
  }
#ifdef ANIMATED_MESH_FEATURES_WITH_HDF5
  AMF::IO::Animation_file_data<double> data =
      AMF::IO::read_hdf5<double>(file, c.clip, c.faces_dataset.empty() ? "faces" : c.faces_dataset, choose_memory);
  const double rate_of_dfaust = 60; // these files do not tell
  for (std::size_t f = 0; f < data.frames; ++f) data.times.push_back(double(f) / rate_of_dfaust);
  return data;
#else
  throw_without(file, "HDF5", "HDF5");
#endif
}

} // namespace Detect_features
