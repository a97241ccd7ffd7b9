// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_DEFAULT_BALL_RADIUS_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_DEFAULT_BALL_RADIUS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// The mean over the vertices of how many vertices a flat ball has if all edges are as long as those around its centre,
// in the mean, l: a disk of radius r by the area of a vertex in equilateral triangles, 2 pi / sqrt(3) (r / l)^2; at
// most all.
inline double mean_ball_size(const Rest_shape& shape, double radius)
{
  constexpr double vertices_of_unit_ball = 3.6275987284684357; // 2 pi / sqrt(3)
  const std::size_t n = shape.number_of_vertices();
  double sum = 0;
  for (std::size_t v = 0; v < n; ++v) {
    double length = 0;
    for (Rest_shape::Index e : shape.incident_edges()[v]) length += shape.lengths()[e];
    double size = 1;
    if (length > 0) {
      const double ratio = radius * double(shape.incident_edges()[v].size()) / length;
      size = (std::max)(1., vertices_of_unit_ball * ratio * ratio);
    }
    sum += (std::min)(size, double(n));
  }
  return sum / double(n);
}

// So small that balls have at most 1,500 vertices in the mean by mean_ball_size(), but no less than a hundredth.
inline double bounded_ball_radius(const Rest_shape& shape, double radius)
{
  constexpr double most_vertices = 1500, least_share = 0.01;
  if (!(radius > 0) || double(shape.number_of_vertices()) <= most_vertices) return radius;
  const double least = least_share * radius;
  for (double size; radius > least && (size = mean_ball_size(shape, radius)) > (1 + 1e-9) * most_vertices;)
    radius = (std::max)(least, radius * std::sqrt(most_vertices / size));
  return radius;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesBalls

the radius \f$r = \min(\max(0.045\,D, 3h), 8h)\f$ from which `default_ball_radius()` starts (length), by the diameter and
the mean edge length of the rest shape.
*/
inline double unbounded_ball_radius(const Rest_shape& shape)
{
  const double h = shape.mean_edge_length();
  return (std::min)((std::max)(0.045 * shape.diameter(), 3 * h), 8 * h);
}

/*!
\ingroup PkgAnimatedMeshFeaturesBalls

the default radius \f$r = \min(\max(0.045\,D, 3h), 8h)\f$ of the geodesic balls (length): 4.5 % of the diameter of the
rest shape, but at least 3 mean edge lengths, below which balls contain too few edges (at 1 edge length, 8 % of the
balls of a scanned horse contain none), and at most 8, some 230 vertices a ball: memory and time stay linear in the
number of vertices. (Of meshes beyond some 30,000 vertices the curvature therefore depends on the density; to compare
such, give the radius.)

With smaller balls curvature depends on the mesh: between a horse of 8,431 and its decimation to 4,200 vertices, for
both of which that is above 3 edge lengths, the share of the strongest features that are found again is a tenth larger
than at 2.5 %.

Where a part of a mesh is far denser than the whole, as a detailed head on a coarse figure, mean edge lengths say little
about it, and its balls would have so many vertices that time and memory went with the square of their number. Of meshes
of more than 1,500 vertices the radius is therefore so small that a ball has 1,500 vertices at most, in the mean over
the vertices, where a ball counts as \f$2\pi/\sqrt3\,(r/l)^2\f$ vertices, \f$l\f$ the mean length of the edges at its
centre, and as all of the mesh at most (and no less than a hundredth of what is said above). That count is some 230 for
edges of about one length, and 800 to 1,000 for scanned animals of 20,000 to 30,000 vertices, which it leaves alone.
`O(N)`.
*/
inline double default_ball_radius(const Rest_shape& shape)
{
  return internal::bounded_ball_radius(shape, unbounded_ball_radius(shape));
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_DEFAULT_BALL_RADIUS_H
