// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_VIEWS_SCENE_VIEWS_H
#define PROGRAMS_VIEWS_SCENE_VIEWS_H

#include "scenes/Shown_scene.h"

#include <CGAL/Animated_mesh_features/Applications/select_views.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>

#include <cstddef>
#include <optional>

namespace Programs {

// Where a scene is looked at from, unless the user tells: see select_views(). Cameras look down a little, so that the ground
// is seen, and not so much that the body is seen as on a plan.
struct Scene_views
{
  static constexpr double lowest_elevation = 5, highest_elevation = 50; // degrees

  int up_axis = 1;
  CGAL::Animated_mesh_features::View_selection selection;
  std::size_t cycle = 0; // frames, if the last one is followed by the first

  // The one of the selected views that is good for a frame, by its rank: the first one, unless another shows much more
  // of what lives there.
  std::size_t view_of_frame(std::size_t frame) const;
};

// `up_axis`: none, as probable_up_axis() finds. A second or so of a core for 8,000 vertices.
// throws Input_error if a feature is not of the animation; Cancelled.
Scene_views
scene_views(const Shown_scene& scene, std::optional<int> up_axis,
            CGAL::Animated_mesh_features::Any_visitor visitor = CGAL::Animated_mesh_features::Any_visitor());

// The axis that points up in a scene at rest.
int scene_up_axis(const Shown_scene& scene, std::optional<int> up_axis);

// The scores of all directions around, in the same frames, for a map of them.
CGAL::Animated_mesh_features::View_scores scores_around(const Shown_scene& scene, const Scene_views& views,
                                                        std::size_t subdivisions);

} // namespace Programs

#endif // PROGRAMS_VIEWS_SCENE_VIEWS_H
