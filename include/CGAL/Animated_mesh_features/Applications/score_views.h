// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SCORE_VIEWS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SCORE_VIEWS_H

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/outer_sides.h>
#include <CGAL/Animated_mesh_features/Applications/Surface_view.h>
#include <CGAL/Animated_mesh_features/Applications/View_scores.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Posed_surface.h>
#include <CGAL/Animated_mesh_features/Applications/internal/View_depth_map.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage_scope.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// Directions to be looked from, an opposite one with each that has it: `none` for those that have not.
struct View_pair
{
  static constexpr std::size_t none = std::size_t(-1);
  std::size_t above, below;
};

inline std::vector<View_pair> view_pairs(const std::vector<Eigen::Vector3d>& directions)
{
  typedef std::array<double, 3> Key;
  std::map<Key, std::size_t> waiting; // for their opposite, by its coordinates
  std::vector<View_pair> pairs;
  for (std::size_t d = 0; d < directions.size(); ++d) {
    const Eigen::Vector3d& v = directions[d];
    if (!(std::abs(v.norm() - 1) < 1e-6)) throw Option_error("direction " + std::to_string(d) + " is no unit vector");
    const auto found = waiting.find(Key{{v[0], v[1], v[2]}});
    if (found != waiting.end()) {
      pairs[found->second].below = d;
      waiting.erase(found);
    } else {
      // 0 - x, which is never a negative zero
      waiting.emplace(Key{{0 - v[0], 0 - v[1], 0 - v[2]}}, pairs.size());
      pairs.push_back({d, View_pair::none});
    }
  }
  return pairs;
}

template <class FT, class ViewScore>
void add_scored_views(View_scores& result, const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories,
                      const std::vector<Eigen::Vector3d>& directions, const ViewScore& score, std::size_t resolution,
                      Any_visitor visitor)
{
  const std::vector<std::size_t>& frames = result.frames();
  const std::size_t before = result.directions().size();
  const std::vector<View_pair> pairs = view_pairs(directions);
  result.add_directions(directions);
  const Task_loop<CGAL::Parallel_if_available_tag, Any_visitor> loop(visitor, Stage::VIEWS);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const Rest_shape::Triangle& t : shape.triangles()) triangles.push_back({{t[0], t[1], t[2]}});
  const std::vector<std::int8_t> sides = outer_sides(shape.points(), triangles);
  std::vector<Posed_surface> surfaces(frames.size());
  loop.part(0, 8)(frames.size(), [&](std::size_t k) { surfaces[k] = posed_surface(shape, trajectories, frames[k]); });
  // Long enough for a map to be made for each task, short enough for few threads to wait for each other.
  const std::size_t block = 8, blocks = (pairs.size() + block - 1) / block;
  const Task_loop<CGAL::Parallel_if_available_tag, Any_visitor> rest(visitor, Stage::VIEWS, 1. / 8, 1);
  rest(frames.size() * blocks, [&](std::size_t task) {
    const std::size_t k = task / blocks, first = task % blocks * block;
    View_depth_map map(resolution);
    std::vector<float> seen(result.first_item(k + 1) - result.first_item(k));
    for (std::size_t p = first; p < (std::min)(pairs.size(), first + block); ++p) {
      const Eigen::Vector3d& above = directions[pairs[p].above];
      map.draw(surfaces[k].points, triangles, sides, above, pairs[p].below != View_pair::none);
      for (const bool is_above : {true, false}) {
        const std::size_t d = is_above ? pairs[p].above : pairs[p].below;
        if (d == View_pair::none) continue;
        score(Surface_view(shape, surfaces[k], map, directions[d], is_above, k), seen.data());
        result.set_seen(before + d, k, seen.data());
      }
    }
  });
  result.sum_up();
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesViews

scores directions to look at an animation from.

Hidden parts are found by a depth map for each frame and pair of opposite directions, of `resolution` times `resolution`
texels on a sphere around the body. With rays through \cgal's AABB tree it takes ten to twenty times as long; 256 texels
differ from them for some 6 % of the vertices, 512 for 2 to 4 % and take about one and a half times as long.

\tparam TriangleMesh, FT of the animation.
\tparam ViewScore a model of `ViewScore`.
\param animation the animation.
\param frames the frames to look at, ascending, as many as the score has.
\param directions unit vectors, from the body to the camera.
\param score is asked about each frame and direction, from several threads at a time.
\param visitor is told of `Stage::VIEWS`.
\param resolution from 16 to 4096.
\returns what each direction shows in each frame. For `D` directions, `K` frames and `I` items in \f$O(D K N + D I)\f$ time,
  and \f$O(K N + D I)\f$ memory: a millisecond of a core for a direction and frame of 8,000 vertices. The same bits whatever
  the number of threads.
\throw Option_error if a frame is not there, frames do not fit the score, or a direction is no unit vector; Cancelled.
*/
template <class TriangleMesh, class FT, class ViewScore>
View_scores score_views(const Frame_sequence<TriangleMesh, FT>& animation, const std::vector<std::size_t>& frames,
                        const std::vector<Eigen::Vector3d>& directions, const ViewScore& score,
                        Any_visitor visitor = Any_visitor(), std::size_t resolution = 256)
{
  if (frames.empty() || frames.size() != score.number_of_frames())
    throw Option_error("the score is for " + std::to_string(score.number_of_frames()) + " frames, not for " +
                       std::to_string(frames.size()));
  for (std::size_t k = 0; k < frames.size(); ++k)
    if (frames[k] >= animation.number_of_frames() || (k > 0 && frames[k] <= frames[k - 1]))
      throw Option_error("the frames that are looked at must ascend, and be below " +
                         std::to_string(animation.number_of_frames()));
  if (resolution < 16 || resolution > 4096)
    throw Option_error("a depth map of " + std::to_string(resolution) + " texels a side; choose 16 to 4096");
  std::vector<std::size_t> first_items;
  for (std::size_t k = 0; k <= frames.size(); ++k) first_items.push_back(score.first_item(k));
  std::vector<double> weights;
  for (std::size_t i = 0; i < first_items.back(); ++i) weights.push_back(score.weight(i));
  View_scores result(frames, first_items, weights);
  internal::Stage_scope stage(visitor, Stage::VIEWS);
  internal::add_scored_views(result, animation.rest_shape(), animation.trajectories(), directions, score, resolution,
                             visitor);
  return result;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SCORE_VIEWS_H
