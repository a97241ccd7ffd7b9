// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_PLACE_FEATURE_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_PLACE_FEATURE_H

#include <CGAL/Animated_mesh_features/Rest_shape.h>
#include <CGAL/Animated_mesh_features/internal/Flat_animation.h>
#include <CGAL/Animated_mesh_features/internal/refine_extremum.h>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Where and when a feature is: time, triangle and barycentric coordinates, position on the rest shape and on the moving
// surface, linear between the frames before and behind.
template <class FT, class Feature>
void place_feature(const Flat_animation<FT>& animation,
                   const Extremum& e,
                   const Refined_scales& scales,
                   Feature& feature)
{
  const Refined_place place = refine_place(animation.rest, e);
  feature.frame = e.frame;
  feature.time = (double(e.frame) + scales.frame) * animation.frame_duration;
  feature.triangle = place.triangle;
  feature.barycentric_coordinates = place.barycentric;
  // an extremum is neither in the first nor in the last frame, and its offset at most half a frame
  const std::size_t before = std::size_t(double(e.frame) + scales.frame);
  const double behind_weight = double(e.frame) + scales.frame - double(before);
  Rest_shape::Point rest = Rest_shape::Point::Zero(), now = rest;
  for (int i = 0; i < 3; ++i) {
    const std::size_t v = place.triangle[i];
    rest += place.barycentric[i] * animation.rest.points()[v];
    now += place.barycentric[i] *
           ((1 - behind_weight) * animation.point(v, before) + behind_weight * animation.point(v, before + 1));
  }
  for (int i = 0; i < 3; ++i) {
    feature.rest_position[i] = rest[i];
    feature.position[i] = now[i];
  }
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_PLACE_FEATURE_H
