// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_INTERNAL_FIGURE_MOTION_H
#define ANIMATED_MESH_GENERATORS_INTERNAL_FIGURE_MOTION_H

#include "Figure_body.h"
#include "Rigid_motion.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace Animated_mesh_generators {
namespace internal {

/*!
How the figure runs on the spot: the turn of each bone about its joint as a function of time, periodic.

Legs and arms turn once per period, what bounces (hips, ears, head) twice. Tail and ears follow like a whip: each bone
does what the one before did a little earlier.
*/
class Figure_motion
{
public:
  /// \param period the time of two steps, left and right (seconds).
  Figure_motion(const Figure_body& body, double period)
    : m_body(body)
    , m_period(period)
  {}

  /// where each bone is at a time (seconds).
  std::vector<Rigid_motion> operator()(double time) const
  {
    const double phase = phase_at(time);
    std::map<std::string, Angles> angles = angles_at(phase);
    std::vector<Rigid_motion> result;
    for (std::size_t i = 0; i < m_body.bones().size(); ++i) {
      const Figure_body::Bone& bone = m_body.bones()[i];
      const Rigid_motion turn = Rigid_motion::turn(angles[bone.name].rotation(), bone.joint);
      if (i == 0) {
        // In the air between the steps.
        const Eigen::Vector3d hop(0.015 * std::sin(2 * phase), 0, 0.03 - 0.06 * std::cos(2 * phase + 0.4));
        result.push_back(Rigid_motion(Eigen::Quaterniond::Identity(), hop) * turn);
      } else
        result.push_back(result[bone.parent] * turn);
    }
    return result;
  }

  /// by how much each bone is turned against the one that carries it, relative to rest (radians, 0 to pi).
  std::vector<double> turns(double time) const
  {
    std::map<std::string, Angles> angles = angles_at(phase_at(time));
    std::vector<double> result;
    for (const Figure_body::Bone& bone : m_body.bones()) {
      const Eigen::Quaterniond q = angles[bone.name].rotation();
      result.push_back(2 * std::atan2(q.vec().norm(), std::abs(q.w())));
    }
    return result;
  }

private:
  // Turns in radians about the axes of the rest shape: positive roll lowers the right, positive pitch the front,
  // positive yaw turns to the left.
  struct Angles
  {
    double roll = 0, pitch = 0, yaw = 0;

    Eigen::Quaterniond rotation() const
    {
      return Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()));
    }
  };

  double phase_at(double time) const { return boost::math::constants::two_pi<double>() * time / m_period; }

  static std::map<std::string, Angles> angles_at(double phase)
  {
    std::map<std::string, Angles> angles;
    pose_trunk(phase, angles);
    pose_tail(phase, angles);
    pose_side("left", 1, phase, angles);
    pose_side("right", -1, phase + boost::math::constants::pi<double>(), angles);
    return angles;
  }

  // A soft pulse from 0 to 1, once per turn, at its top when the phase is 0.
  static double pulse(double phase) { return std::pow(0.5 + 0.5 * std::cos(phase), 2); }

  static void pose_trunk(double phase, std::map<std::string, Angles>& a)
  {
    a["pelvis"] = {0.06 * std::sin(phase), 0.1 + 0.04 * std::cos(2 * phase), -0.18 * std::cos(phase)};
    a["chest"] = {-0.08 * std::sin(phase), 0.12 + 0.05 * std::cos(2 * phase + 0.5), 0.4 * std::cos(phase)};
    a["neck"] = {0, -0.08 - 0.05 * std::cos(2 * phase), -0.12 * std::cos(phase)};
    a["head"] = {0.06 * std::sin(phase + 0.5), -0.12 - 0.07 * std::cos(2 * phase - 0.6), -0.1 * std::cos(phase)};
  }

  static void pose_tail(double phase, std::map<std::string, Angles>& a)
  {
    for (int i = 0; i < 6; ++i)
      a["tail" + std::to_string(i)] = {0, 0.13 * std::sin(2 * phase - 0.6 * i) - 0.06,
                                       0.26 * std::sin(phase - 0.75 * i)};
  }

  // `y` is 1 for the left side, -1 for the right one; at phase 0 the thigh is farthest forward.
  static void pose_side(const std::string& side, double y, double phase, std::map<std::string, Angles>& a)
  {
    const double quarter = boost::math::constants::half_pi<double>();
    a[side + " thigh"] = {0, -0.3 - 0.75 * std::cos(phase), 0};
    // The knee is bent most while the thigh swings forward, a quarter before its foremost place.
    a[side + " shin"] = {0, 0.35 + 1.1 * pulse(phase + quarter + 0.3), 0};
    // The foot pushes off behind, and is drawn up in front.
    a[side + " foot"] = {0, -0.25 + 0.75 * pulse(phase + 2 * quarter - 0.3), 0};
    a[side + " toes"] = {0, -0.5 * pulse(phase + 2 * quarter + 0.2), 0};

    a[side + " arm"] = {-0.35 * y, 0.7 * std::cos(phase), 0};
    a[side + " forearm"] = {0, -0.95 + 0.35 * std::cos(phase + 0.3), -0.45 * y};
    a[side + " hand"] = {0, -0.2 + 0.3 * std::cos(phase - 0.8), 0};

    for (int i = 0; i < 3; ++i) {
      // Both ears flap together with the hops, and a little with the turning head.
      const double hops = 2 * (phase + (y > 0 ? 0 : 2 * quarter)) - 0.9 * i;
      a[side + " ear" + std::to_string(i)] = {0.1 * y * std::sin(hops - 0.5), -0.12 + 0.28 * std::sin(hops), 0};
    }
  }

  const Figure_body& m_body;
  double m_period;
};

} // namespace internal
} // namespace Animated_mesh_generators

#endif // ANIMATED_MESH_GENERATORS_INTERNAL_FIGURE_MOTION_H
