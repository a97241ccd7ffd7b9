// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_RIG_EVENTS_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_RIG_EVENTS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Evaluation/internal/Point_grid.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

A moment at which a joint is bent most.
*/
struct Joint_event
{
  std::size_t joint = 0; ///< of which region
  double time = 0;       ///< seconds
  double angle = 0;      ///< against rest (degrees)
  double prominence = 0; ///< of the angle (degrees), see `Prominent_maximum`
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

Which moments count, and what is near one of them.
*/
struct Rig_options
{
  double least_prominence = 10;     ///< an event has at least this prominence (degrees): more than wavering
  double least_angle = 10;          ///< a feature may be at an event of at least this angle (degrees)
  double least_recalled_angle = 20; ///< an event of at least this angle (degrees) should have a feature
  double largest_distance = 0.02;   ///< of a feature from a region, a share of the size; at most its \f$\sigma\f$
  double frames = 1.5;              ///< a feature may be so many frames early or late, or
  double share_of_tau = 0.5;        ///< this share of its \f$\tau\f$, if that is more
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

A feature, where the regions of a rig are.
*/
struct Rig_feature
{
  std::size_t vertex = 0; ///< of the points that the regions are made of
  double time = 0;        ///< seconds
  double sigma = 0;       ///< length
  double tau = 0;         ///< seconds
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

What features and events have to do with one another.
*/
struct Rig_matches
{
  std::vector<double> found;         ///< of each event of `Rig_events::recalled()` whether a feature is at it: 1 or 0
  std::vector<double> at_event;      ///< of each feature whether it is at an event: 1 or 0
  std::vector<std::size_t> of_joint; ///< of each joint, how many features are at an event of it
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

The extreme bends of a skeleton's joints as truth about an animation: a feature is expected where a joint is bent, when
it is bent most. A feature is at an event if its vertex is near the joint's region and its time near the event's; see
`Rig_options`.

Events in the first two frames or in the last two do not count, since no detector could find them.
*/
class Rig_events
{
public:
  typedef Rest_shape::Index Index; ///< of a point

  /*!
  takes over regions and events.

  \param points `N`, at rest; are kept by reference.
  \param size of the body (length): the diagonal of its bounding box.
  \param regions for each joint the points that move where it bends; empty if it moves none, whose events do not count.
  \param events in any order.
  \param frames the number of frames.
  \param frame_duration the time between two frames (s).
  \param options see there.
  \throw Option_error if the size or the time between two frames is not positive.
  \throw Input_error if a region has a point that is not there, or an event has no region.
  */
  Rig_events(const std::vector<Rest_shape::Point>& points, double size, const std::vector<std::vector<Index>>& regions,
             const std::vector<Joint_event>& events, std::size_t frames, double frame_duration,
             Rig_options options = Rig_options())
    : m_points(&points)
    , m_limit(options.largest_distance * size)
    , m_frame_duration(frame_duration)
    , m_options(options)
    , m_joints(joints_of_points(points.size(), regions))
    , m_grid(points, points_of(regions), checked_distance(m_limit, frame_duration))
    , m_events_of(regions.size())
  {
    const double duration = double(frames) * frame_duration;
    for (const Joint_event& e : events) {
      if (e.joint >= regions.size())
        throw Input_error("an event is of joint " + std::to_string(e.joint) + ", there are " +
                          std::to_string(regions.size()) + " regions");
      if (regions[e.joint].empty() || !(e.prominence >= options.least_prominence)) continue;
      if (!(e.time > frame_duration && e.time < duration - 2 * frame_duration)) continue;
      const bool is_recalled = e.angle >= options.least_recalled_angle;
      if (!is_recalled && !(e.angle >= options.least_angle)) continue;
      m_events_of[e.joint].push_back({e.time, is_recalled ? m_recalled.size() : not_recalled});
      if (is_recalled) m_recalled.push_back(e);
    }
  }

  /// the events that should have a feature.
  const std::vector<Joint_event>& recalled() const { return m_recalled; }

  /// the number of joints.
  std::size_t number_of_joints() const { return m_events_of.size(); }

  /// tells which features are at which events. \f$O(k)\f$ for a feature with `k` points of regions nearby.
  /// \throw Input_error if a feature's vertex is none of the points.
  Rig_matches operator()(const std::vector<Rig_feature>& features) const
  {
    Rig_matches matches;
    matches.found.assign(m_recalled.size(), 0);
    matches.of_joint.assign(m_events_of.size(), 0);
    std::vector<Index> joints;
    for (const Rig_feature& f : features) {
      find_joints(f, joints);
      bool is_at_event = false;
      for (Index j : joints) {
        bool is_at_joint = false;
        for (const Moment& moment : m_events_of[j]) {
          if (!is_at_time(f, moment.time)) continue;
          is_at_joint = true;
          if (moment.recalled != not_recalled) matches.found[moment.recalled] = 1;
        }
        if (is_at_joint) ++matches.of_joint[j];
        is_at_event = is_at_event || is_at_joint;
      }
      matches.at_event.push_back(is_at_event ? 1 : 0);
    }
    return matches;
  }

private:
  static constexpr std::size_t not_recalled = std::size_t(-1);

  struct Moment
  {
    double time;
    std::size_t recalled; // rank among those, or `not_recalled`
  };

  static double checked_distance(double distance, double frame_duration)
  {
    if (!(distance > 0)) throw Option_error("the size of a body with a rig, and the distance, must be positive");
    if (!(frame_duration > 0)) throw Option_error("the time between two frames must be positive");
    return distance;
  }

  static Compressed_rows joints_of_points(std::size_t points, const std::vector<std::vector<Index>>& regions)
  {
    std::vector<std::vector<Index>> joints(points);
    for (std::size_t j = 0; j < regions.size(); ++j)
      for (Index v : regions[j]) {
        if (v >= points)
          throw Input_error("the region of joint " + std::to_string(j) + " has vertex " + std::to_string(v) +
                            ", there are " + std::to_string(points));
        joints[v].push_back(Index(j));
      }
    return Compressed_rows(std::move(joints));
  }

  static std::vector<Index> points_of(const std::vector<std::vector<Index>>& regions)
  {
    std::vector<Index> points;
    for (const std::vector<Index>& region : regions) points.insert(points.end(), region.begin(), region.end());
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  }

  // The joints in whose regions a feature is, each once.
  void find_joints(const Rig_feature& f, std::vector<Index>& joints) const
  {
    if (f.vertex >= m_points->size())
      throw Input_error("a feature is at vertex " + std::to_string(f.vertex) + ", the rig has " +
                        std::to_string(m_points->size()));
    joints.clear();
    m_grid.for_each_near((*m_points)[f.vertex], [&](Index v, double distance) {
      if (distance > f.sigma) return;
      joints.insert(joints.end(), m_joints[v].begin(), m_joints[v].end());
    });
    std::sort(joints.begin(), joints.end());
    joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  }

  bool is_at_time(const Rig_feature& f, double time) const
  {
    const double reach = (std::max)(m_options.frames * m_frame_duration, m_options.share_of_tau * f.tau);
    return std::abs(f.time - time) <= reach;
  }

  const std::vector<Rest_shape::Point>* m_points;
  double m_limit, m_frame_duration;
  Rig_options m_options;
  Compressed_rows m_joints; // of each point
  internal::Point_grid m_grid;
  std::vector<std::vector<Moment>> m_events_of; // of each joint
  std::vector<Joint_event> m_recalled;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_RIG_EVENTS_H
