// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_READ_GLTF_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_READ_GLTF_H

#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>
#include <CGAL/Animated_mesh_features/IO/Linked_files.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_model_builder.h>
#include <CGAL/Animated_mesh_features/IO/internal/parse_gltf.h>

#include <tiny_gltf.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesModels

reads an animated model from a glTF 2.0 file, `.gltf` (with data inside or beside it) or `.glb`: the nodes, meshes,
skins and morph targets of its default scene, and all animations. Images are not looked at. Lists, strips and fans of
triangles are read, points and lines left out; accessors may be strided, sparse, or of normalised integers.

A file may come from anybody: no other file is opened than those of its buffers, as `linked` allows, and these only if
they are regular files; brackets are nested 64 times at most; nothing takes more memory than what the file holds accounts
for, see `internal::Gltf_accessor_reader`.

Needs tinygltf 2.6 or newer: whoever includes this header links with Debian's `libtinygltf` (CMake:
`TinyGLTF::TinyGLTF`), or defines `TINYGLTF_IMPLEMENTATION` in one of the program's files; and nlohmann-json 3.9.

\param file `.gltf` or `.glb`.
\param linked which files buffers may be in.

\throws Input_error if the file cannot be read, is no glTF 2.0, needs an extension that is not known here, or is not
consistent; the message names the node, primitive, vertex, accessor, buffer or channel.
*/
inline Keyframed_model read_gltf(const std::string& file, Linked_files linked = Linked_files::BESIDE_MODEL)
{
  tinygltf::Model gltf;
  std::vector<std::string> linked_files = internal::parse_gltf(file, linked, gltf);
  Keyframed_model model = internal::Gltf_model_builder(gltf, file)();
  model.linked_files = std::move(linked_files);
  return model;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_READ_GLTF_H
