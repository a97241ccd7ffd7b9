// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Model_file.h"

#include <CGAL/Animated_mesh_features/IO/file_format.h>
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

#include <cstddef>
#include <string>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

Model_format model_format(AMF::IO::File_format format)
{
  switch (format) {
  case AMF::IO::File_format::GLTF:
    return Model_format::GLTF;
  case AMF::IO::File_format::FBX:
  case AMF::IO::File_format::COLLADA:
  case AMF::IO::File_format::X:
    return Model_format::ASSIMP;
  case AMF::IO::File_format::HDF5:
    return Model_format::HDF5;
  default:
    return Model_format::NONE;
  }
}

[[maybe_unused]] AMF::IO::Clip_sampling sampling(const Reading_options& o)
{
  AMF::IO::Clip_sampling s;
  s.clip = o.clip;
  s.frames = o.clip_frames;
  s.frames_per_second = o.frames_per_second;
  s.there_and_back = o.there_and_back;
  s.skip_bad_frames = o.skip_bad_frames;
  s.part = o.part;
  return s;
}

[[noreturn, maybe_unused]] void throw_without(const std::string& file, const std::string& library,
                                              const std::string& option)
{
  throw AMF::Input_error(file + ": this program was built without " + library +
                         ", which reads such files (CMake option ANIMATED_MESH_FEATURES_WITH_" + option + ")");
}

#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
AMF::IO::Keyframed_model gltf_model(const Reading_options& o)
{
  const AMF::IO::Linked_files linked =
      o.allow_outside ? AMF::IO::Linked_files::ANYWHERE : AMF::IO::Linked_files::BESIDE_MODEL;
  return AMF::IO::read_gltf(o.inputs.front(), linked);
}
#endif

} // namespace

Model_format model_format(const std::vector<std::string>& inputs)
{
  for (const std::string& input : inputs) {
    const Model_format format = model_format(AMF::IO::file_format(input));
    if (format == Model_format::NONE) continue;
    if (inputs.size() > 1) throw AMF::Input_error(input + ": an animated model must be the only input");
    return format;
  }
  return Model_format::NONE;
}

AMF::IO::Animation_file_data<double> read_model_file(const Reading_options& o, Model_format format,
                                                     [[maybe_unused]] const AMF::IO::Memory_chooser& choose_memory)
{
  const std::string& file = o.inputs.front();
  AMF::IO::check_readable(file);
  if (format == Model_format::GLTF) {
#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
    return AMF::IO::sample_clip<double>(gltf_model(o), sampling(o), file, choose_memory);
#else
    throw_without(file, "tinygltf", "GLTF");
#endif
  }
  if (format == Model_format::ASSIMP) {
#ifdef ANIMATED_MESH_FEATURES_WITH_ASSIMP
    AMF::IO::Animation_file_data<double> data =
        AMF::IO::sample_clip<double>(AMF::IO::read_assimp(file), sampling(o), file, choose_memory);
    data.remarks.insert(data.remarks.begin(), "read through assimp, best effort: compare with what you expect");
    return data;
#else
    throw_without(file, "assimp", "ASSIMP");
#endif
  }
#ifdef ANIMATED_MESH_FEATURES_WITH_HDF5
  AMF::IO::Animation_file_data<double> data = AMF::IO::read_hdf5<double>(
      file, o.clip, o.faces_dataset.empty() ? "faces" : o.faces_dataset, choose_memory, mesh_reading_options(o));
  const double rate_of_dfaust = 60; // these files do not tell
  for (std::size_t f = 0; f < data.frames; ++f) data.times.push_back(double(f) / rate_of_dfaust);
  return data;
#else
  throw_without(file, "HDF5", "HDF5");
#endif
}

std::vector<std::string> clip_names(const Reading_options& o)
{
  const Model_format format = model_format(o.inputs);
  const std::string& file = o.inputs.front();
  if (format == Model_format::NONE)
    throw AMF::Option_error("--clip goes with a file that holds several animations: an animated model, or HDF5");
  AMF::IO::check_readable(file);
  std::vector<std::string> names;
  if (format == Model_format::GLTF) {
#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
    names = AMF::IO::clip_names(gltf_model(o));
#else
    throw_without(file, "tinygltf", "GLTF");
#endif
  } else if (format == Model_format::ASSIMP) {
#ifdef ANIMATED_MESH_FEATURES_WITH_ASSIMP
    names = AMF::IO::clip_names(AMF::IO::read_assimp(file));
#else
    throw_without(file, "assimp", "ASSIMP");
#endif
  } else {
#ifdef ANIMATED_MESH_FEATURES_WITH_HDF5
    names = AMF::IO::hdf5_sequences(file);
#else
    throw_without(file, "HDF5", "HDF5");
#endif
  }
  if (names.empty()) throw AMF::Input_error(file + ": holds no animation");
  return names;
}

} // namespace Programs
