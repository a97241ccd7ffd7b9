// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_FIGURE_JOINTS_H
#define ANIMATED_MESH_GENERATORS_FIGURE_JOINTS_H

#include "Generated_animation.h"
#include "internal/Figure_body.h"
#include "internal/Figure_motion.h"

#include <boost/math/constants/constants.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace Animated_mesh_generators {

/*!
A joint of the running figure: how far it is bent at which time, and which part of the surface that moves.
*/
struct Figure_joint
{
  /// of the bone that turns about it.
  std::string name;

  /// the vertices of which the bone, and what hangs on it, has more than a tenth and less than nine tenths, ascending.
  std::vector<std::size_t> region;

  /// the angle against rest at each of the times that were asked for (degrees).
  std::vector<double> angles;
};

/*!
The joints of the running figure, with their angles at any times: they are functions of time, whatever the frames.

\param mesh of the figure, at rest.
\param period as of `Articulated_figure_options` (seconds).
\param times seconds.
*/
inline std::vector<Figure_joint> figure_joints(const Generated_animation::Mesh& mesh, double period,
                                               const std::vector<double>& times)
{
  const double degrees = 180 / boost::math::constants::pi<double>();
  const internal::Figure_body body;
  const internal::Figure_motion motion(body, period);
  const std::vector<internal::Figure_body::Bone>& bones = body.bones();
  std::vector<Figure_joint> joints(bones.size());
  for (std::size_t i = 0; i < bones.size(); ++i) joints[i].name = bones[i].name;
  for (double time : times) {
    const std::vector<double> turns = motion.turns(time);
    for (std::size_t i = 0; i < bones.size(); ++i) joints[i].angles.push_back(turns[i] * degrees);
  }
  const double least = 0.1, most = 0.9;
  std::size_t rank = 0;
  for (const auto v : vertices(mesh)) {
    std::vector<double> sums(bones.size(), 0.);
    const Eigen::Vector3d place(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    for (const std::pair<std::size_t, double>& share : body.shares(place)) sums[share.first] += share.second;
    for (std::size_t i = bones.size(); i-- > 1;) sums[bones[i].parent] += sums[i]; // parents come first
    for (std::size_t i = 0; i < bones.size(); ++i)
      if (sums[i] > least && sums[i] < most) joints[i].region.push_back(rank);
    ++rank;
  }
  return joints;
}

} // namespace Animated_mesh_generators

#endif // ANIMATED_MESH_GENERATORS_FIGURE_JOINTS_H
