// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_ARTICULATED_FIGURE_H
#define ANIMATED_MESH_GENERATORS_ARTICULATED_FIGURE_H

#include "Generated_animation.h"
#include "internal/Figure_body.h"
#include "internal/Figure_motion.h"
#include "internal/mesh_figure.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace Animated_mesh_generators {

/*!
Sampling and pace of the running figure.
*/
struct Articulated_figure_options
{
  /// how many vertices to make, to within about 5 percent; at least 1000, or the thin parts could not be told in
  /// triangles.
  std::size_t number_of_vertices = 9000;

  std::size_t number_of_frames = 48;

  /// frames in a second.
  double frame_rate = 30;

  /// the time of two steps, left and right (seconds). The defaults show two periods, so that the last frame is followed
  /// by the first.
  double period = 0.8;
};

/*!
A small animal with long ears and a long tail, made of nothing but formulas, that runs on the spot.

It stands on z = 0 at rest, is about two units high and looks along +x. Its surface is a smooth union of round cones
around a skeleton, meshed by marching tetrahedra and remeshed to nearly equilateral triangles: closed, connected,
without handles. It is moved by its bones with blended dual quaternions.

The motion is a function of time and of the place at rest. Two calls with the same options give the same bits. Takes
one or two seconds for the default size, four for 30000 vertices.

\exception CGAL::Animated_mesh_features::Option_error if there are too few vertices or no frames, or if the frame rate
or the period is not positive.
*/
inline Generated_animation articulated_figure(const Articulated_figure_options& options = Articulated_figure_options())
{
  typedef CGAL::Animated_mesh_features::Option_error Option_error;
  internal::check_frames(options.number_of_frames, options.frame_rate);
  if (options.number_of_vertices < 1000) throw Option_error("the figure needs at least 1000 vertices");
  if (!(options.period > 0) || !std::isfinite(options.period))
    throw Option_error("the figure's period must be positive and finite");

  const internal::Figure_body body;
  Generated_animation result;
  result.mesh = internal::mesh_figure(body, options.number_of_vertices);
  result.frame_duration = 1 / options.frame_rate;

  std::vector<Eigen::Vector3d> rest;
  std::vector<std::vector<std::pair<std::size_t, double>>> shares;
  for (const auto v : vertices(result.mesh)) {
    rest.push_back(internal::to_vector(result.mesh.point(v)));
    shares.push_back(body.shares(rest.back()));
  }

  const internal::Figure_motion motion(body, options.period);
  for (std::size_t f = 0; f < options.number_of_frames; ++f) {
    const std::vector<internal::Rigid_motion> bones = motion(double(f) / options.frame_rate);
    std::vector<Generated_animation::Kernel::Point_3> positions;
    positions.reserve(rest.size());
    for (std::size_t i = 0; i < rest.size(); ++i) {
      internal::Rigid_motion average = internal::Rigid_motion::zero();
      for (const auto& share : shares[i]) average.add(share.second, bones[share.first]);
      average.normalise();
      positions.push_back(internal::to_point(average(rest[i])));
    }
    result.frames.push_back(std::move(positions));
  }
  return result;
}

} // namespace Animated_mesh_generators

#endif // ANIMATED_MESH_GENERATORS_ARTICULATED_FIGURE_H
