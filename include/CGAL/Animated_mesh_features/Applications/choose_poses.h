// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_CHOOSE_POSES_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_CHOOSE_POSES_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Evaluation/Random_numbers.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

chooses frames that stand for all: first those that are preferred, then again and again the one that is farthest from
all that were chosen (T. F. Gonzalez, Clustering to minimize the maximum intercluster distance, 1985, which is within
a factor of two of the best choice). Two poses are as far apart as the distances of 1,024 random pairs of vertices
differ (root mean square), which do not change when the whole body moves.

\param rest the connectivity.
\param trajectories `F` frames.
\param number how many frames, at least 1; all `F` if there are no more.
\param preferred frames to begin with, of which the first `number` are taken; repetitions are left out. Without any, the
  first is the one that is farthest from the first frame.
\returns frames in the order in which they were chosen; all of them in their own order if all are taken.
\throw Option_error if `number` is 0 or a preferred frame is not one.

\f$O(F\,\cdot\f$ `number` \f$\cdot\f$ 1024) time, 8 KB for each frame.
*/
template <class FT>
std::vector<std::size_t> choose_poses(const Rest_shape& rest, const Vertex_trajectories<FT>& trajectories,
                                      std::size_t number, const std::vector<std::size_t>& preferred = {})
{
  const std::size_t frames = trajectories.number_of_frames();
  if (number == 0) throw Option_error("at least one pose is needed");
  for (std::size_t f : preferred)
    if (f >= frames)
      throw Option_error("there is no frame " + std::to_string(f) + " to be a pose; frames are 0 to " +
                         std::to_string(frames - 1));
  std::vector<std::size_t> chosen;
  if (number >= frames) {
    for (std::size_t f = 0; f < frames; ++f) chosen.push_back(f);
    return chosen;
  }
  constexpr std::size_t pairs = 1024;
  const std::vector<Rest_shape::Index>& vertices = rest.measured_vertices();
  std::vector<double> lengths(frames * pairs);
  Random_numbers random(0);
  for (std::size_t k = 0; k < pairs; ++k) {
    const std::size_t a = vertices[random.below(vertices.size())], b = vertices[random.below(vertices.size())];
    for (std::size_t f = 0; f < frames; ++f)
      lengths[f * pairs + k] = (trajectories.point(a, f) - trajectories.point(b, f)).norm();
  }
  std::vector<double> distance(frames, std::numeric_limits<double>::infinity());
  const auto approach = [&](std::size_t pose) {
    for (std::size_t f = 0; f < frames; ++f) {
      double sum = 0;
      for (std::size_t k = 0; k < pairs; ++k) {
        const double d = lengths[f * pairs + k] - lengths[pose * pairs + k];
        sum += d * d;
      }
      distance[f] = (std::min)(distance[f], sum);
    }
  };
  const auto farthest = [&] {
    return std::size_t(std::max_element(distance.begin(), distance.end()) - distance.begin());
  };
  const auto choose = [&](std::size_t pose) {
    if (chosen.size() == number || std::find(chosen.begin(), chosen.end(), pose) != chosen.end()) return;
    chosen.push_back(pose);
    approach(pose);
  };
  for (std::size_t f : preferred) choose(f);
  if (chosen.empty()) {
    approach(0);
    const std::size_t first = farthest();
    std::fill(distance.begin(), distance.end(), std::numeric_limits<double>::infinity());
    choose(first);
  }
  while (chosen.size() < number) {
    const std::size_t next = farthest();
    if (!(distance[next] > 0)) break; // all others repeat one that is chosen
    choose(next);
  }
  return chosen;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_CHOOSE_POSES_H
