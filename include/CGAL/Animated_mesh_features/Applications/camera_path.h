// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_CAMERA_PATH_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_CAMERA_PATH_H

#include <CGAL/Animated_mesh_features/Applications/View_scores.h>
#include <CGAL/Animated_mesh_features/Applications/View_sphere.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesViews

How `camera_path()` moves a camera.
*/
struct Camera_path_options
{
  /// degrees a second, positive. Default: 45, a slow pan.
  double largest_speed = 45;

  /// what a turn by one radian has to show to be worth it, as a part of all that there is to be seen; not negative. Default:
  /// 0.01, which keeps a camera still that would only wander.
  double cost_of_turning = 0.01;

  /// whether the clip is a cycle: the path ends where it began. Default: no.
  bool is_cyclic = false;
};

/*!
\ingroup PkgAnimatedMeshFeaturesViews

Where a camera looks from while a clip is played.
*/
class Camera_path
{
public:
  /// a path through directions at equal distances in time, from time 0 on.
  /// \param directions unit vectors, at least one, none opposite to the next.
  /// \param interval the time from one to the next (seconds).
  /// \param score what the path shows of all that there is to be seen.
  Camera_path(std::vector<Eigen::Vector3d> directions, double interval, double score)
    : m_directions(std::move(directions))
    , m_interval(interval)
    , m_score(score)
  {}

  /// the directions that it goes through, `interval()` apart in time; of a cycle the first one is the last one.
  const std::vector<Eigen::Vector3d>& directions() const { return m_directions; }

  /// seconds.
  double interval() const { return m_interval; }

  /// what is seen along the path, with the camera in each interval at the nearest of its directions, from 0 to 1.
  double score() const { return m_score; }

  /// the direction to the camera at a time (seconds), on great circles from one direction to the next; before and after,
  /// the first and the last one.
  Eigen::Vector3d direction(double time) const
  {
    const double at = (std::min)((std::max)(0., time / m_interval), double(m_directions.size() - 1));
    const std::size_t i = (std::min)(std::size_t(at), m_directions.size() - 1),
                      j = (std::min)(i + 1, m_directions.size() - 1);
    const Eigen::Vector3d &a = m_directions[i], &b = m_directions[j];
    const double angle = View_sphere::angle(a, b), s = at - double(i);
    if (!(angle > 1e-9)) return a;
    return (std::sin((1 - s) * angle) * a + std::sin(s * angle) * b) / std::sin(angle);
  }

private:
  std::vector<Eigen::Vector3d> m_directions;
  double m_interval, m_score;
};

namespace internal {

// The best path through a layer of scores for each key, from a direction on that is given or, if none is, from any.
class Path_search
{
public:
  static constexpr std::size_t any = std::size_t(-1);

  Path_search(const std::vector<Eigen::Vector3d>& directions, double largest_angle, double cost)
    : m_steps(directions.size())
  {
    for (std::size_t d = 0; d < directions.size(); ++d)
      for (std::size_t e = 0; e < directions.size(); ++e) {
        const double angle = d == e ? 0 : View_sphere::angle(directions[d], directions[e]);
        if (angle <= largest_angle) m_steps[d].push_back({e, cost * angle});
      }
  }

  // Directions, one for each layer; `value` is the sum of their scores less the cost of turning. With a start, the path
  // must end where it can go on to the start.
  std::vector<std::size_t> run(const std::vector<std::vector<double>>& layers, std::size_t start, double& value) const
  {
    const double least = -(std::numeric_limits<double>::max)();
    const std::size_t n = m_steps.size();
    std::vector<double> now(n, least), next(n);
    for (std::size_t d = 0; d < n; ++d)
      if (start == any || d == start) now[d] = layers.front()[d];
    std::vector<std::vector<std::size_t>> from;
    const auto come = [&](std::size_t d, double& best) {
      std::size_t source = d;
      best = least;
      for (const Step& s : m_steps[d])
        if (now[s.from] > least && now[s.from] - s.cost > best) best = now[s.from] - s.cost, source = s.from;
      return source;
    };
    for (std::size_t j = 1; j < layers.size(); ++j) {
      from.emplace_back(n);
      for (std::size_t d = 0; d < n; ++d) {
        double best;
        from.back()[d] = come(d, best);
        next[d] = best > least ? best + layers[j][d] : least;
      }
      now.swap(next);
    }
    std::size_t end = 0;
    if (start == any) {
      for (std::size_t d = 0; d < n; ++d)
        if (now[d] > now[end]) end = d;
      value = now[end];
    } else {
      end = come(start, value);
    }
    std::vector<std::size_t> path(layers.size());
    for (std::size_t j = layers.size(); j-- > 0; end = j > 0 ? from[j - 1][end] : end) path[j] = end;
    return path;
  }

private:
  struct Step
  {
    std::size_t from;
    double cost;
  };
  std::vector<std::vector<Step>> m_steps; // to each direction
};

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesViews

finds the path of a camera that shows most in the course of a clip, among those that turn no faster than is allowed, by
dynamic programming: at equal distances in time, so long that the camera gets from a direction to its neighbours, the
directions are chosen whose scores in the frames around sum up to most, less the cost of turning.

\param scores of directions that are neighbours of each other, such as those of a `View_sphere` or the part of one that is
  allowed, in frames that are spread over the clip, such as `even_frames()`.
\param spacing the largest angle from a direction to its neighbours (radians), `View_sphere::longest_edge()`.
\param number_of_frames of the clip, `F`.
\param frame_duration the time between two frames (s). A cycle takes `F` of them, another clip `F - 1`.
\param options see there.
\returns a path that goes through one direction only if the clip is too short for the camera to turn.
\throw Option_error if there are no directions, or an option makes no sense.

Exact among such paths. For `D` directions, `J` of them one after the other and `n` neighbours of each, \f$O(D^2 + J D n)\f$
time, and \f$O(J D^2 n)\f$ for a cycle, for which every direction is tried as the first.
*/
inline Camera_path camera_path(const View_scores& scores, double spacing, std::size_t number_of_frames,
                               double frame_duration, const Camera_path_options& options = Camera_path_options())
{
  if (scores.directions().empty()) throw Option_error("a camera has no directions to look from");
  if (!(options.largest_speed > 0 && std::isfinite(options.largest_speed)))
    throw Option_error("the largest speed of a camera must be positive");
  if (!(options.cost_of_turning >= 0)) throw Option_error("the cost of turning a camera must not be negative");
  if (!(spacing > 0 && frame_duration > 0) || number_of_frames == 0)
    throw Option_error("a camera's path needs directions with a distance, and a clip with a duration");
  const std::size_t n = scores.directions().size();
  const double speed = options.largest_speed * double(EIGEN_PI) / 180;
  const double duration = double(options.is_cyclic ? number_of_frames : number_of_frames - 1) * frame_duration;
  const double fitting = std::floor(duration * speed / spacing * (1 + 1e-12));
  // a frame more often would show nothing new
  const std::size_t intervals = std::size_t((std::min)(fitting, double(number_of_frames)));
  const bool is_still = intervals < (options.is_cyclic ? 2u : 1u);
  const std::size_t keys = is_still ? 1 : options.is_cyclic ? intervals : intervals + 1;
  const double interval = is_still ? (std::max)(duration, frame_duration) : duration / double(intervals);
  std::vector<std::vector<double>> layers(keys, std::vector<double>(n, 0));
  for (std::size_t k = 0; k < scores.frames().size(); ++k) {
    const double at = std::floor(double(scores.frames()[k]) * frame_duration / interval + 0.5);
    const std::size_t j = is_still            ? 0
                          : options.is_cyclic ? std::size_t(at) % keys
                                              : (std::min)(std::size_t(at), keys - 1);
    for (std::size_t d = 0; d < n; ++d) layers[j][d] += scores.score(d, k);
  }
  const internal::Path_search search(scores.directions(), speed * interval * (1 + 1e-9), options.cost_of_turning);
  double value = 0;
  std::vector<std::size_t> path = search.run(layers, internal::Path_search::any, value);
  if (options.is_cyclic && !is_still) {
    std::vector<std::size_t> best;
    double most = 0;
    for (std::size_t start = 0; start < n; ++start) {
      path = search.run(layers, start, value);
      if (best.empty() || value > most) best = path, most = value;
    }
    path = best;
  }
  double score = 0;
  std::vector<Eigen::Vector3d> directions;
  for (std::size_t j = 0; j < keys; ++j) {
    score += layers[j][path[j]];
    directions.push_back(scores.directions()[path[j]]);
  }
  if (options.is_cyclic && !is_still) directions.push_back(directions.front());
  return Camera_path(directions, interval, score);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_CAMERA_PATH_H
