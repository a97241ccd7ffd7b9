// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SELECT_VIEWS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SELECT_VIEWS_H

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Applications/Entropy_view_score.h>
#include <CGAL/Animated_mesh_features/Applications/Feature_view_score.h>
#include <CGAL/Animated_mesh_features/Applications/View_angles.h>
#include <CGAL/Animated_mesh_features/Applications/View_scores.h>
#include <CGAL/Animated_mesh_features/Applications/View_sphere.h>
#include <CGAL/Animated_mesh_features/Applications/covering_views.h>
#include <CGAL/Animated_mesh_features/Applications/probable_up_axis.h>
#include <CGAL/Animated_mesh_features/Applications/score_views.h>
#include <CGAL/Animated_mesh_features/Applications/view_frames.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesViews

What `select_views()` chooses from.
*/
struct View_options
{
  /// what points up, of any length but 0. Default: none, `probable_up_axis()` of the rest shape.
  std::optional<Eigen::Vector3d> up;

  /// how often the icosahedron of directions is subdivided. Default: 2, 162 directions 18 degrees apart; the best ones are
  /// refined.
  std::size_t subdivisions = 2;

  /// how often the best directions are refined, up to three of them that are apart, each time among six around each at half
  /// the angle of before. Default: 3, to about 2 degrees.
  std::size_t refinements = 3;

  /// by how much of the best score that of another one of the refined directions may be lower and still be as good: of
  /// these, the one nearest to the front is the first view, so that small changes of the mesh do not make it jump. Default:
  /// 0.02.
  double tie = 0.02;

  /// how many frames are looked at. Default: 16; all 48 to 96 of a gallop or a walk change the score of the chosen view by
  /// some 1 % of the amplitude.
  std::size_t most_frames = 16;

  /// whether the last frame is followed by the first: a feature near one end lives on at the other. Default: no.
  bool is_cyclic = false;

  /// how many views are chosen. Default: 3.
  std::size_t most_views = 3;

  /// the least elevation of a view that may be chosen (degrees). Default: all but those from so far below that an upright
  /// camera would turn over.
  double lowest_elevation = -80;

  /// the largest elevation of a view that may be chosen (degrees). Default: as the least one, from above.
  double highest_elevation = 80;
};

/*!
\ingroup PkgAnimatedMeshFeaturesViews

A view that `select_views()` chose.
*/
struct Selected_view
{
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); ///< from the body to the camera, a unit vector
  View_angles angles;                                   ///< the same in degrees
  double score = 0;                                     ///< what it shows alone, from 0 to 1
  double covered = 0;                                   ///< what it and those before it show together
  std::size_t rank = 0;                                 ///< in `View_scores::directions()`
};

/*!
\ingroup PkgAnimatedMeshFeaturesViews

What `select_views()` found.
*/
struct View_selection
{
  Eigen::Vector3d up = Eigen::Vector3d::UnitY(); ///< unit vector
  std::vector<Selected_view> views;              ///< the best one first
  View_scores scores;                            ///< of all directions that were looked from
};

namespace internal {

// Directions around another one, in an order that does not depend on how it was reached.
inline std::vector<Eigen::Vector3d> directions_around(const Eigen::Vector3d& d, double angle)
{
  const Eigen::Vector3d u = d.unitOrthogonal(), v = d.cross(u);
  std::vector<Eigen::Vector3d> result;
  for (int i = 0; i < 6; ++i) {
    const double turn = i * double(EIGEN_PI) / 3;
    result.push_back((std::cos(angle) * d + std::sin(angle) * (std::cos(turn) * u + std::sin(turn) * v)).normalized());
  }
  return result;
}

inline void check_view_options(const View_options& o)
{
  if (o.up && !(o.up->allFinite() && o.up->norm() > 0))
    throw Option_error("the direction that points up has no length");
  if (!(o.lowest_elevation <= o.highest_elevation))
    throw Option_error("there is no elevation from " + std::to_string(o.lowest_elevation) + " to " +
                       std::to_string(o.highest_elevation) + " degrees");
  if (o.most_views == 0) throw Option_error("at least one view has to be chosen");
  if (!(o.tie >= 0 && o.tie < 1)) throw Option_error("a tie of " + std::to_string(o.tie) + " is not from 0 to 1");
}

// The best direction, and others that are nearly as good and far from it and each other.
inline std::vector<std::size_t> separate_views(const View_scores& scores, double angle)
{
  const std::size_t most = 3;
  const double share = 0.95;
  std::vector<std::size_t> order(scores.directions().size()), result;
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return scores.score(a) > scores.score(b); });
  for (std::size_t d : order) {
    if (result.size() == most || scores.score(d) < share * scores.score(order.front())) break;
    if (std::none_of(result.begin(), result.end(), [&](std::size_t other) {
          return View_sphere::angle(scores.directions()[d], scores.directions()[other]) < angle;
        }))
      result.push_back(d);
  }
  return result;
}

// Of the views that are as good as the best one, that nearest to the front: to where azimuth and elevation are 0, or to -y
// if z points up, as programs for modelling have it.
inline std::size_t frontmost_of_best(const View_scores& scores, const std::vector<std::size_t>& views,
                                     const Eigen::Vector3d& up, double tie)
{
  int axis = 0;
  up.cwiseAbs().maxCoeff(&axis);
  const Eigen::Vector3d front = view_direction({axis == 2 ? -90. : 0., 0.}, up);
  double best = 0;
  for (std::size_t d : views) best = (std::max)(best, scores.score(d));
  std::size_t result = scores.directions().size();
  for (std::size_t d : views)
    if (scores.score(d) >= (1 - tie) * best &&
        (result == scores.directions().size() ||
         scores.directions()[d].dot(front) > scores.directions()[result].dot(front)))
      result = d;
  return result;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesViews

chooses where to look at an animation from, by any score: directions of a `View_sphere` are scored, the best ones are
refined, of those that are as good as each other the one nearest to the front is chosen, and others are added that show
most of what it hides. The camera follows the body and stands upright.

\param animation the animation; a body that walks off is followed.
\param frames the frames to look at, as many as the score has.
\param score a model of `ViewScore`.
\param options see there.
\param visitor is told of `Stage::VIEWS`, which begins anew for each refinement.
\throw Option_error if an option makes no sense, or no direction has an elevation that is allowed; see `score_views()`.
*/
template <class TriangleMesh, class FT, class ViewScore>
View_selection select_views(const Frame_sequence<TriangleMesh, FT>& animation, const std::vector<std::size_t>& frames,
                            const ViewScore& score, const View_options& options, Any_visitor visitor = Any_visitor())
{
  internal::check_view_options(options);
  Eigen::Vector3d up = options.up.value_or(Eigen::Vector3d::Zero()).normalized();
  if (!options.up) up = Eigen::Vector3d::Unit(probable_up_axis(animation.rest_shape()));
  const double slack = 1e-9;
  const auto is_allowed = [&](const Eigen::Vector3d& d) {
    const double elevation = view_angles(d, up).elevation;
    return elevation >= options.lowest_elevation - slack && elevation <= options.highest_elevation + slack;
  };
  const View_sphere sphere(options.subdivisions);
  std::vector<Eigen::Vector3d> directions;
  for (const Eigen::Vector3d& d : sphere.directions())
    if (is_allowed(d)) directions.push_back(d);
  if (directions.empty()) // a band between the directions
    for (int azimuth = -180; azimuth < 180; azimuth += 10)
      directions.push_back(
          view_direction({double(azimuth), (options.lowest_elevation + options.highest_elevation) / 2}, up));
  View_selection result{up, {}, score_views(animation, frames, directions, score, visitor)};
  View_scores& scores = result.scores;
  double angle = sphere.longest_edge() / 2;
  std::vector<std::size_t> peaks = internal::separate_views(scores, 3 * angle);
  for (std::size_t i = 0; i < options.refinements; ++i, angle /= 2) {
    std::vector<Eigen::Vector3d> finer;
    std::vector<std::size_t> peak_of; // of each of them
    for (std::size_t p = 0; p < peaks.size(); ++p)
      for (const Eigen::Vector3d& d : internal::directions_around(scores.directions()[peaks[p]], angle))
        if (is_allowed(d)) finer.push_back(d), peak_of.push_back(p);
    if (finer.empty()) continue;
    const std::size_t before = scores.directions().size();
    internal::Stage_scope stage(visitor, Stage::VIEWS);
    internal::add_scored_views(scores, animation.rest_shape(), animation.trajectories(), finer, score, 256, visitor);
    for (std::size_t k = 0; k < finer.size(); ++k)
      if (scores.score(before + k) > scores.score(peaks[peak_of[k]])) peaks[peak_of[k]] = before + k;
  }
  const auto is_any = [](const Eigen::Vector3d&) { return true; };
  const std::size_t first = internal::frontmost_of_best(scores, peaks, up, options.tie);
  for (const Covering_view& v : covering_views(scores, options.most_views, is_any, first)) {
    const Eigen::Vector3d& d = scores.directions()[v.rank];
    result.views.push_back({d, view_angles(d, up), v.score, v.covered, v.rank});
  }
  return result;
}

/*!
\ingroup PkgAnimatedMeshFeaturesViews

chooses where to look at an animation from so that its features are seen, by a `Feature_view_score`, in the frames that
`view_frames()` tells. Without features, an `Entropy_view_score` decides.

\param animation whose surface is looked at.
\param features a range of `Feature_point`.
\param options how many views, from which elevations; see there.
\param visitor is told of the stage `Stage::VIEWS`.
\throw Input_error if a feature is not of the animation; Option_error, Cancelled as above.
*/
template <class TriangleMesh, class FT, class FeatureRange>
View_selection select_views(const Frame_sequence<TriangleMesh, FT>& animation, const FeatureRange& features,
                            const View_options& options = View_options(), Any_visitor visitor = Any_visitor())
{
  const std::size_t n = animation.number_of_frames();
  const std::vector<std::size_t> frames =
      view_frames(features, n, animation.frame_duration(), options.most_frames, options.is_cyclic);
  if (features.begin() == features.end())
    return select_views(animation, frames, Entropy_view_score(frames.size()), options, visitor);
  const Feature_view_score score(animation.rest_shape(), frames, n, animation.frame_duration(), features, 0.5,
                                 options.is_cyclic);
  return select_views(animation, frames, score, options, visitor);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SELECT_VIEWS_H
