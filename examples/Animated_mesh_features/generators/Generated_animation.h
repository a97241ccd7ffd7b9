// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_GENERATED_ANIMATION_H
#define ANIMATED_MESH_GENERATORS_GENERATED_ANIMATION_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Animated_mesh_generators {

/*!
What a generator makes: a triangle mesh in its rest shape, and where its vertices are in each frame.

Frame `f` shows the motion at the time `f * frame_duration` (seconds). A generator's motion is a function of time and
of the place on the rest shape, so that neither the resolution nor the frame rate changes it.
*/
struct Generated_animation
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

  /// the rest shape: closed or with boundary, connected, manifold, without removed elements.
  Mesh mesh;

  /// `F x N`: the positions of the vertices in each frame, in the order of `vertices(mesh)`.
  std::vector<std::vector<Kernel::Point_3>> frames;

  /// the time between two frames (seconds).
  double frame_duration = 0;
};

namespace internal {

/// throws `CGAL::Animated_mesh_features::Option_error` unless there are frames, and time passes between them.
inline void check_frames(std::size_t number_of_frames, double frame_rate)
{
  typedef CGAL::Animated_mesh_features::Option_error Option_error;
  if (number_of_frames == 0) throw Option_error("the animation needs at least one frame");
  // written so that a NaN is refused
  if (!(frame_rate > 0) || !std::isfinite(frame_rate)) throw Option_error("the frame rate must be positive and finite");
}

} // namespace internal
} // namespace Animated_mesh_generators

#endif // ANIMATED_MESH_GENERATORS_GENERATED_ANIMATION_H
