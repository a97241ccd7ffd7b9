// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/short_usage.h"

#include "output/Viewer_page.h"

#include <string>

namespace Detect_features {

namespace {

constexpr bool reads_gltf =
#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
    true;
#else
    false;
#endif

constexpr bool reads_through_assimp =
#ifdef ANIMATED_MESH_FEATURES_WITH_ASSIMP
    true;
#else
    false;
#endif

constexpr bool reads_hdf5 =
#ifdef ANIMATED_MESH_FEATURES_WITH_HDF5
    true;
#else
    false;
#endif

constexpr bool draws_pictures =
#ifdef DETECT_FEATURES_WITH_PICTURES
    true;
#else
    false;
#endif

} // namespace

std::string short_usage()
{
  std::string with, without;
  const auto tell = [&](bool is_built, const std::string& part) {
    std::string& list = is_built ? with : without;
    list += (list.empty() ? "" : "; ") + part;
  };
  tell(reads_gltf, "glTF (.glb, .gltf)");
  tell(reads_through_assimp, "FBX, Collada, X (.fbx, .dae, .x)");
  tell(reads_hdf5, "HDF5 (.h5)");
  tell(Programs::missing_viewer().empty(), "--html");
  tell(draws_pictures, "--png, --plot");

  std::string text =
      R"(detect_features finds where, when, how large and how long a moving triangle mesh deforms distinctively.

  detect_features walk.obj walk.pc2 -o features.json   a mesh and its moving vertices; the features go to a file
  detect_features frames/ --fps 25 --html view.html    a folder with a mesh for each frame; a page for the browser
  detect_features hand.glb --clip Fist                 an animated model; the features go to the standard output

)";
  if (!with.empty()) text += "This program was built with: " + with + "\n";
  if (!without.empty()) text += "and without: " + without + "\n";
  return text + "All formats and options, with their defaults and units: detect_features --help\n";
}

} // namespace Detect_features
