// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_LINKED_FILES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_LINKED_FILES_H

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesModels

Which files a model may take its data from. In any case they are regular files, named relative to the model's folder.
*/
enum class Linked_files
{
  BESIDE_MODEL, ///< in the folder of the model or below it, also where symbolic links lead: the default, since a model of
                ///< somebody else's does not choose which files are opened
  ANYWHERE      ///< wherever the model says
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_LINKED_FILES_H
