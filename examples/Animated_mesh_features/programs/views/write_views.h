// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_VIEWS_WRITE_VIEWS_H
#define PROGRAMS_VIEWS_WRITE_VIEWS_H

#include "scenes/Shown_scene.h"

#include <ostream>

namespace Programs {

// Writes the views of a scene, `scene.views` or else scene_views(), as JSON:
// - "up", the vector that points up; "frames", those that were looked at, from 0;
// - "views", the best first: "rank" from 1, "azimuth" and "elevation" (degrees, as --view takes them), "direction" (unit
//   vector from the body to the camera), "score" and "covered" (0 to 1: what it shows of the features, alone and together
//   with those before it), "covered_of_visible", the latter as a part of "visible", what all directions that were looked
//   from show together, which no choice exceeds;
// - "camera": a path for the whole clip, no faster than 45 degrees a second: "interval" (s) between its "keys", each with
//   "time" (s), angles and direction, of a cycle the last as the first, a period later; "score", and "still", the score of
//   the best camera that stands still, both of the same 32 frames.
// throws Input_error as scene_views(); errors of the stream are left in its state.
void write_views(std::ostream& os, const Shown_scene& scene);

} // namespace Programs

#endif // PROGRAMS_VIEWS_WRITE_VIEWS_H
