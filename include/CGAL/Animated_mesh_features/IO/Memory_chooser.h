// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_MEMORY_CHOOSER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_MEMORY_CHOOSER_H

#include <CGAL/Animated_mesh_features/Numerics/memory/Field_memory.h>

#include <cstddef>
#include <functional>
#include <memory>

namespace CGAL {
namespace Animated_mesh_features {

namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

Is told the numbers of vertices and frames of an animation once they are known, before memory for them is taken, and
returns where its coordinates are to live - and with them all that is computed from them. It may throw. Where there is
none, they live on the heap. Where that number is known late, it is asked before about fewer vertices, so that it can
refuse early: what it returns then is not used.
*/
typedef std::function<std::shared_ptr<Field_memory>(std::size_t, std::size_t)> Memory_chooser;

namespace internal {

inline std::shared_ptr<Field_memory> chosen_memory(const Memory_chooser& choose, std::size_t vertices,
                                                   std::size_t frames)
{
  return choose ? choose(vertices, frames) : Field_memory::heap();
}

} // namespace internal
} // namespace IO

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_MEMORY_CHOOSER_H
