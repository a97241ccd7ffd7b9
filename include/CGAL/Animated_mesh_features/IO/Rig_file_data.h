// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_RIG_FILE_DATA_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_RIG_FILE_DATA_H

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

The joints of an animated body, what moves where they bend, and when they are bent most: truth that an animation comes with
if a skeleton moves it. See `read_rig_events()`.
*/
struct Rig_file_data
{
  /// A moment at which a joint is bent most.
  struct Maximum
  {
    double time = 0;       ///< seconds from the first frame
    double angle = 0;      ///< of the joint against rest (degrees), not negative
    double prominence = 0; ///< how far the angle falls before it rises above this maximum (degrees), not negative
  };

  /// A joint of the skeleton.
  struct Joint
  {
    std::string name;                ///< as the skeleton has it
    std::vector<std::size_t> region; ///< the vertices that both sides of the joint move; empty if there are none
    std::vector<Maximum> maxima;     ///< in the order of time
  };

  std::size_t vertices = 0;  ///< of the animation, their number
  std::size_t frames = 0;    ///< of the animation, their number
  double frame_duration = 0; ///< seconds
  std::vector<Joint> joints; ///< in any order
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_RIG_FILE_DATA_H
