// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_PAINTING_FILE_DATA_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_PAINTING_FILE_DATA_H

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

What somebody painted on an animation: where it moves in a way that catches the eye, say. See `read_painting()`.
*/
struct Painting_file_data
{
  /// Vertices that are painted for some time.
  struct Stroke
  {
    std::size_t first_frame = 0;       ///< from this frame
    std::size_t last_frame = 0;        ///< to this one, itself included
    std::vector<std::size_t> vertices; ///< in any order, each once or several times
  };

  std::size_t vertices = 0;  ///< of the animation, their number
  std::size_t frames = 0;    ///< of the animation, their number
  double frame_duration = 0; ///< seconds

  std::string painter;         ///< who painted; files of the same painter belong together
  std::vector<Stroke> strokes; ///< in the order of the file
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_PAINTING_FILE_DATA_H
