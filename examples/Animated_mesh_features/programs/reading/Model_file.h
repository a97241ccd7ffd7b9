// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_READING_MODEL_FILE_H
#define PROGRAMS_READING_MODEL_FILE_H

#include "reading/Reading_options.h"

#include <CGAL/Animated_mesh_features/IO/read_animation.h>

#include <string>
#include <vector>

namespace Programs {

// Formats in which one file holds everything, read by libraries that the program may have been built without.
enum class Model_format
{
  NONE,
  GLTF,
  ASSIMP,
  HDF5
};

// By the ending of the name, or by the first bytes of the file.
// throws Input_error if such a file is not the only input.
Model_format model_format(const std::vector<std::string>& inputs);

// throws Input_error if the program was built without the library, as IO::read_gltf(), IO::read_assimp() and
// IO::read_hdf5() do, and as IO::sample_clip() does.
CGAL::Animated_mesh_features::IO::Animation_file_data<double>
read_model_file(const Reading_options& options, Model_format format,
                const CGAL::Animated_mesh_features::IO::Memory_chooser& choose_memory);

// The names of all clips in a file; `Reading_options::clip` does not matter.
// throws Option_error if the input holds no clips whatever is in it; Input_error if there are none, or as above.
std::vector<std::string> clip_names(const Reading_options& options);

} // namespace Programs

#endif // PROGRAMS_READING_MODEL_FILE_H
