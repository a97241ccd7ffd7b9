// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_LAST_FRAME_REPEATS_FIRST_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_LAST_FRAME_REPEATS_FIRST_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

whether the last frame of an animation repeats the first, as that of a clip that is made to be played in a loop often does.
In a cyclic animation the frame after the last is the first again; the repetition is to be left out, so that the period is
F - 1 frames.

Frames are compared by the root mean square distance of their vertices, each frame around its own mean, so that a body may
have walked on. The last repeats the first if that is at most a hundredth of what it is in the mean from frame to frame, or the
rounding of coordinates in single precision, and is more for the first and the second frame and for the last two: a body that
rests at both ends repeats nothing.

Time is linear in `N F`.

\param x, y, z coordinates, `N x F`.
\returns `false` if there are fewer than 3 frames, or no vertices.
*/
template <class FT>
bool last_frame_repeats_first(const Spatio_temporal_field<FT>& x, const Spatio_temporal_field<FT>& y,
                              const Spatio_temporal_field<FT>& z)
{
  const std::size_t vertices = x.number_of_rows(), frames = x.number_of_frames();
  if (frames < 3 || vertices == 0) return false;
  // from each frame to the next, from the last to the first
  std::vector<double> squares(frames, 0);
  double largest = 0;
  for (const Spatio_temporal_field<FT>* c : {&x, &y, &z}) {
    const auto step = [&](const FT* row, std::size_t f) {
      return double(row[f + 1 < frames ? f + 1 : 0]) - double(row[f]);
    };
    std::vector<double> mean(frames, 0);
    for (std::size_t v = 0; v < vertices; ++v)
      for (std::size_t f = 0; f < frames; ++f) {
        mean[f] += step(c->row(v), f) / double(vertices);
        largest = (std::max)(largest, std::abs(double(c->row(v)[f])));
      }
    for (std::size_t v = 0; v < vertices; ++v)
      for (std::size_t f = 0; f < frames; ++f) {
        const double difference = step(c->row(v), f) - mean[f];
        squares[f] += difference * difference / double(vertices);
      }
  }
  double usual = 0;
  for (std::size_t f = 0; f + 1 < frames; ++f) usual += std::sqrt(squares[f]) / double(frames - 1);
  const double tolerance = 0.01 * usual + 2 * double(std::numeric_limits<float>::epsilon()) * largest;
  const auto is_repetition = [&](std::size_t f) { return std::sqrt(squares[f]) <= tolerance; };
  return is_repetition(frames - 1) && !is_repetition(0) && !is_repetition(frames - 2);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_LAST_FRAME_REPEATS_FIRST_H
