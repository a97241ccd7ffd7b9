// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OUTPUT_RESULT_FILES_H
#define PROGRAMS_OUTPUT_RESULT_FILES_H

#include "output/Output_options.h"
#include "output/Scene_files.h"
#include "reading/Sequence.h"

#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/IO/Result_description.h>

#include <memory>
#include <vector>

namespace Programs {

// All files that are written. They are opened first, so that a folder that does not exist is noticed before hours of
// computation, and take their places last, together, when each of them is complete.
class Result_files
{
public:
  // throws Output_error, as all below; Option_error if the program was built without what writes a scene.
  explicit Result_files(const Output_options& options);

  // Writes the field to all files that want it.
  void write_field(Field kind, const Values& field);
  void write_features(const std::vector<Feature>& features,
                      const CGAL::Animated_mesh_features::IO::Result_description& description);
  void write_scenes(const Shown_scene& scene);

  void commit();

private:
  typedef CGAL::Animated_mesh_features::IO::Output_file Output_file;

  template <class Kind>
  struct Open_file
  {
    Kind kind;
    std::unique_ptr<Output_file> file;
  };

  template <class Kind>
  static std::vector<Open_file<Kind>> opened(const std::vector<Requested_file<Kind>>& requested,
                                             CGAL::Animated_mesh_features::IO::Output_sync sync);

  Scene_files m_scenes;
  std::vector<Open_file<Field>> m_fields;
  std::vector<Open_file<Format>> m_features;
  std::unique_ptr<Output_file> m_vertex_map;
};

} // namespace Programs

#endif // PROGRAMS_OUTPUT_RESULT_FILES_H
