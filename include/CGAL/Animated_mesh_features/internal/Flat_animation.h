// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_FLAT_ANIMATION_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_FLAT_ANIMATION_H

#include <CGAL/Animated_mesh_features/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/exceptions.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// An animation as the kernels see it: no descriptors, no property maps, the coordinates of a vertex contiguous over
// the frames.
template <class FT>
struct Flat_animation
{
  Rest_shape rest;
  Spatio_temporal_field<FT> x, y, z; // N x F
  double frame_duration = 0;         // seconds

  std::size_t number_of_vertices() const { return x.number_of_rows(); }
  std::size_t number_of_frames() const { return x.number_of_frames(); }

  Rest_shape::Point point(std::size_t v, std::size_t f) const
  {
    return Rest_shape::Point(x(v, f), y(v, f), z(v, f));
  }

  void resize(std::size_t n, std::size_t f)
  {
    x = Spatio_temporal_field<FT>(n, f);
    y = Spatio_temporal_field<FT>(n, f);
    z = Spatio_temporal_field<FT>(n, f);
  }

  // Returns false if a coordinate is not finite.
  template <class Point_3>
  bool set_point(std::size_t v, std::size_t f, const Point_3& p)
  {
    x(v, f) = FT(CGAL::to_double(p.x()));
    y(v, f) = FT(CGAL::to_double(p.y()));
    z(v, f) = FT(CGAL::to_double(p.z()));
    return std::isfinite(x(v, f)) && std::isfinite(y(v, f)) && std::isfinite(z(v, f));
  }

  std::vector<Rest_shape::Point> frame(std::size_t f) const
  {
    std::vector<Rest_shape::Point> points(number_of_vertices());
    for (std::size_t v = 0; v < points.size(); ++v) points[v] = point(v, f);
    return points;
  }
};

inline void check_clock(std::size_t number_of_frames, double frame_duration)
{
  // a feature has a frame before and a frame behind it
  if (number_of_frames < 3)
    throw Input_error("the animation has " + std::to_string(number_of_frames) +
                      " frame(s); at least 3 are needed, since a feature has a frame before and one behind it");
  if (!(frame_duration > 0) || !std::isfinite(frame_duration))
    throw Input_error("the time between frames is " + std::to_string(frame_duration) + " s; it must be positive");
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_FLAT_ANIMATION_H
