// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "views/Scene_views.h"

#include <algorithm>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

std::size_t Scene_views::view_of_frame(std::size_t frame) const
{
  const double much_more = 1.5;
  const AMF::View_scores& scores = selection.scores;
  std::size_t k = 0;
  const auto distance = [&](std::size_t i) {
    const std::size_t f = scores.frames()[i], away = f > frame ? f - frame : frame - f;
    return cycle > 0 ? (std::min)(away, cycle - away) : away;
  };
  for (std::size_t i = 0; i < scores.frames().size(); ++i)
    if (distance(i) < distance(k)) k = i;
  std::size_t best = 0;
  for (std::size_t i = 1; i < selection.views.size(); ++i)
    if (scores.score(selection.views[i].rank, k) > scores.score(selection.views[best].rank, k)) best = i;
  return scores.score(selection.views[best].rank, k) > much_more * scores.score(selection.views[0].rank, k) ? best : 0;
}

int scene_up_axis(const Shown_scene& scene, std::optional<int> up_axis)
{
  return up_axis ? *up_axis : AMF::probable_up_axis(scene.sequence.rest_shape());
}

Scene_views scene_views(const Shown_scene& scene, std::optional<int> up_axis, AMF::Any_visitor visitor)
{
  const int axis = scene_up_axis(scene, up_axis);
  AMF::View_options options;
  options.up = Eigen::Vector3d::Unit(axis);
  options.lowest_elevation = Scene_views::lowest_elevation;
  options.highest_elevation = Scene_views::highest_elevation;
  options.is_cyclic = scene.is_cyclic;
  return {axis, AMF::select_views(scene.sequence, scene.features, options, visitor),
          scene.is_cyclic ? scene.sequence.number_of_frames() : 0};
}

AMF::View_scores scores_around(const Shown_scene& scene, const Scene_views& views, std::size_t subdivisions)
{
  const std::vector<Eigen::Vector3d> directions = AMF::View_sphere(subdivisions).directions();
  const std::vector<std::size_t>& frames = views.selection.scores.frames();
  const auto& sequence = scene.sequence;
  if (scene.features.empty())
    return AMF::score_views(sequence, frames, directions, AMF::Entropy_view_score(frames.size()));
  return AMF::score_views(sequence, frames, directions,
                          AMF::Feature_view_score(sequence.rest_shape(), frames, sequence.number_of_frames(),
                                                  sequence.frame_duration(), scene.features, 0.5, scene.is_cyclic));
}

} // namespace Programs
