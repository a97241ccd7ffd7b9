// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_REST_UNIT_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_REST_UNIT_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The largest factor between the median edge of a rest shape and of the frames that passes as deformation. Bodies
// that move keep their median edge within some per cent; the horse's published reference, in other units than its
// gallop, is 1.677 times smaller.
constexpr double largest_unit_ratio = 1.3;

// The median over all edges of length in the middle frame / length at rest.
template <class FT>
double median_edge_ratio(const Rest_shape& shape, const std::vector<Rest_shape::Point>& rest,
                         const Vertex_trajectories<FT>& trajectories)
{
  const std::size_t f = trajectories.number_of_frames() / 2;
  std::vector<double> ratios;
  ratios.reserve(shape.edges().size());
  for (const Rest_shape::Edge& e : shape.edges()) {
    const double length = (rest[e.source] - rest[e.target]).norm();
    if (length > 0) ratios.push_back((trajectories.point(e.source, f) - trajectories.point(e.target, f)).norm() / length);
  }
  if (ratios.empty()) throw Input_error("the rest shape: all edges have length zero");
  const auto middle = ratios.begin() + std::ptrdiff_t(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

inline void check_rest_unit(double ratio)
{
  if (ratio <= largest_unit_ratio && 1 / ratio <= largest_unit_ratio) return;
  std::ostringstream message;
  message << "the rest shape is in another unit than the frames: the median edge of the frames is " << ratio
          << " times as long; Rest_unit::RESCALE (--rescale-rest) scales the rest shape by that ratio";
  throw Input_error(message.str());
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_REST_UNIT_H
