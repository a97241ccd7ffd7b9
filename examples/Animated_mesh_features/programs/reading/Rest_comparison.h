// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_READING_REST_COMPARISON_H
#define PROGRAMS_READING_REST_COMPARISON_H

#include "reading/Sequence.h"

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace Programs {

typedef std::vector<CGAL::Animated_mesh_features::Rest_shape::Point> Rest_points;

// The first frame in which every vertex is where it is in `points`, but for rounding in files; none, if there is no such
// frame. O(N F) time.
std::optional<std::size_t> frame_at(const Rest_points& points, const Sequence& sequence);

// How the edges of a shape differ from those of the frames.
struct Rest_comparison
{
  double ratio = 1;      // median of the lengths in the middle frame over those of the shape; 0: no edge has a length
  std::size_t frame = 0; // the one that is closest, once the shape is scaled
  double change = 0;     // of its edges there, relative: sqrt(sum (l - l0)^2 / sum l0^2)
  double spread = 0;     // the largest such change between that frame and another one
};

// By up to 30,000 edges: of a larger mesh every second, third...
Rest_comparison compare_with_frames(const Rest_points& points, const Sequence& sequence, bool scaled);

// Whether the animation begins at rest: edges change less between the first two frames than by a fiftieth of what they
// change most between any two successive ones. By some edges, as above.
bool begins_still(const Sequence& sequence);

} // namespace Programs

#endif // PROGRAMS_READING_REST_COMPARISON_H
