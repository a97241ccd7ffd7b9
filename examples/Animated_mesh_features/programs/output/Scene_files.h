// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_SCENE_FILES_H
#define DETECT_FEATURES_SCENE_FILES_H

#include "reading/Animation.h"
#include "detect_features/Command_line.h"

#include "scenes/Shown_scene.h"

#include <memory>
#include <vector>

namespace Detect_features {

using Programs::Shown_scene;

// An output that shows a scene, open since it was made; what it is, is known to Scene_files.cpp only.
class Scene_file
{
public:
  virtual ~Scene_file() = default;
  virtual void write(const Shown_scene& scene) = 0; // throws Output_error
  virtual void commit() = 0;                        // throws Output_error
};

// The files that show the features on the surface. Their writers are compiled on their own: detection, which takes a
// compiler minutes, does not see them.
class Scene_files
{
public:
  explicit Scene_files(const Command_line& command_line);

  void write(const Shown_scene& scene);
  void commit();

private:
  std::vector<std::unique_ptr<Scene_file>> m_files;
};

} // namespace Detect_features

#endif // DETECT_FEATURES_SCENE_FILES_H
