// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_BENDING_CYLINDER_H
#define ANIMATED_MESH_GENERATORS_BENDING_CYLINDER_H

#include "Bending_cylinder_motion.h"
#include "Generated_animation.h"
#include "internal/Straight_cylinder.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace Animated_mesh_generators {

/*!
Shape, sampling and motion of a cylinder that stands on the origin along +z and bends in the xz-plane.

The defaults are made for detectors of features in space and time: two bends alike in everything but time, the upper
one four times faster than the middle one; 60 frames in 2 s, in which the fast bend takes nine; surface stretched and
compressed by about a half.
*/
struct Bending_cylinder_options
{
  double radius = 0.4;
  double height = 7;

  /// whether two flat discs close the cylinder.
  bool closed = true;

  /// the number of vertices on a circle; rounded up to a multiple of six, which lets the discs be regular. All other
  /// numbers follow from it: rows are as far apart as makes the triangles near-equilateral.
  std::size_t vertices_around = 36;

  std::size_t number_of_frames = 60;

  /// frames in a second.
  double frame_rate = 30;

  /// the bends, none of which need be apart from the others in space or time.
  std::vector<Cylinder_bend> bends = {{5.2, 1.6, 1.1, 0.5, 0.3}, {3.0, 1.6, -1.1, 1.0, 1.2}};
};

namespace internal {

inline void check_cylinder(const Bending_cylinder_options& o)
{
  typedef CGAL::Animated_mesh_features::Option_error Option_error;
  check_frames(o.number_of_frames, o.frame_rate);
  if (!(o.radius > 0) || !(o.height > 0) || !std::isfinite(o.radius) || !std::isfinite(o.height))
    throw Option_error("the cylinder's radius and height must be positive and finite");
  for (const Cylinder_bend& b : o.bends) {
    if (!(b.region_length > 0) || !(b.duration > 0))
      throw Option_error("a bend's region and duration must have a length");
    // Where the axis' radius of curvature is less than the cylinder's, cross-sections would cut each other on the inner
    // side. Bends whose regions overlap are taken at their worst together.
    double curvature = 0;
    for (const Cylinder_bend& c : o.bends)
      if (2 * std::abs(b.axial_position - c.axial_position) < b.region_length + c.region_length)
        curvature += c.largest_curvature();
    if (!(curvature * o.radius < 1)) throw Option_error("the cylinder is too thick for such sharp bends");
  }
}

} // namespace internal

/// the number of vertices that `bending_cylinder()` makes.
inline std::size_t number_of_cylinder_vertices(const Bending_cylinder_options& o)
{
  return internal::Straight_cylinder(o.radius, o.height, o.closed, o.vertices_around).number_of_vertices();
}

/// the `vertices_around` for which `bending_cylinder()` makes a number of vertices that is nearest to the given one.
inline std::size_t vertices_around_for(std::size_t number_of_vertices, Bending_cylinder_options o)
{
  auto distance = [&](std::size_t around) {
    o.vertices_around = around;
    return std::abs(double(number_of_cylinder_vertices(o)) - double(number_of_vertices));
  };
  std::size_t around = 6;
  while (distance(around + 6) < distance(around)) around += 6;
  return around;
}

/*!
An upright cylinder with joints that bend and straighten again: the upper one fast, the middle one slowly and for long.
It is the kind of animation on which Mykhalchuk, Seo and Cordier (*On spatio-temporal feature point detection for
animated meshes*, The Visual Computer, 2014) first show their detector; its features are known, see `Cylinder_bend`.

The rest shape is the straight cylinder, in near-equilateral triangles with staggered rows. Time and memory are
proportional to `N * F`.

\exception CGAL::Animated_mesh_features::Option_error if sizes are not positive, or if a bend is so sharp that the
surface would cut itself.
*/
inline Generated_animation bending_cylinder(const Bending_cylinder_options& options = Bending_cylinder_options())
{
  typedef Bending_cylinder_motion Motion;
  internal::check_cylinder(options);
  Generated_animation result;
  result.mesh =
      internal::Straight_cylinder(options.radius, options.height, options.closed, options.vertices_around).mesh();
  result.frame_duration = 1 / options.frame_rate;

  const Motion motion(options.bends);
  for (std::size_t f = 0; f < options.number_of_frames; ++f) {
    const double time = double(f) / options.frame_rate;
    std::vector<Motion::Point_3> positions;
    positions.reserve(num_vertices(result.mesh));
    // Vertices come in circles of one height, so that one section serves many.
    double z = 0;
    Motion::Section section = motion.section(z, time);
    for (const auto v : vertices(result.mesh)) {
      const Motion::Point_3& p = result.mesh.point(v);
      if (p.z() != z) {
        z = p.z();
        section = motion.section(z, time);
      }
      positions.push_back(Motion::place(section, p));
    }
    result.frames.push_back(std::move(positions));
  }
  return result;
}

} // namespace Animated_mesh_generators

#endif // ANIMATED_MESH_GENERATORS_BENDING_CYLINDER_H
