// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OUTPUT_SCENE_FILES_H
#define PROGRAMS_OUTPUT_SCENE_FILES_H

#include "output/Output_options.h"
#include "scenes/Shown_scene.h"

#include <memory>
#include <vector>

namespace Programs {

// An output that shows a scene, open since it was made; what it is, is known to Scene_files.cpp only.
class Scene_file
{
public:
  virtual ~Scene_file() = default;
  virtual void write(const Shown_scene& scene) = 0; // throws Output_error
  virtual void commit() = 0;                        // throws Output_error
};

// The files that show the features on the surface.
class Scene_files
{
public:
  // throws Output_error; Option_error if the program was built without what writes one.
  explicit Scene_files(const Output_options& options);

  void write(const Shown_scene& scene);
  void commit();

private:
  std::vector<std::unique_ptr<Scene_file>> m_files;
};

} // namespace Programs

#endif // PROGRAMS_OUTPUT_SCENE_FILES_H
