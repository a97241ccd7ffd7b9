// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_WELD_PART_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_WELD_PART_H

#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/Mesh_reading_options.h>
#include <CGAL/Animated_mesh_features/IO/take_part.h>
#include <CGAL/Animated_mesh_features/IO/weld_animation.h>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

takes the part of an animation of meshes that `Mesh_reading_options::part` means, and welds and mends it as the other options
say (`weld_animation()`). An object or a group is taken first (`keep_group()`), so that the rest of the file may be anything;
a component (`keep_component()`) is one of the welded surface.

\throws Input_error see `weld_animation()`; Option_error see `keep_component()`.
*/
template <class FT>
void weld_part(const Mesh_reading_options& options, Animation_file_data<FT>& data)
{
  const bool is_group = keep_group(options.part, data);
  weld_animation(options.welding, options.repair, data);
  if (!is_group && !options.part.empty()) keep_component(options.part, data);
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WELD_PART_H
