// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_BENDING_CYLINDER_H
#define ANIMATED_MESH_GENERATORS_BENDING_CYLINDER_H

#include "Generated_animation.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Animated_mesh_generators {

/*!
One bend of a cylinder: where, how far, when and for how long. It is the known answer for a detector: on the two sides
that face the plane of bending (`x = +radius` and `x = -radius`), at `axial_position` and at `centre_time`, the surface
deforms most.
*/
struct Cylinder_bend
{
  /// the place along the axis (length from the cylinder's foot) at which the axis is curved most.
  double axial_position;

  /// the length of axis that bends, centred at `axial_position`; the axis is straight where no bend reaches.
  double region_length;

  /// the largest angle between the axis below and above the region (radians); positive towards +x.
  double angle;

  /// the time at which the angle is largest (seconds).
  double centre_time;

  /// the time (seconds) that the bend takes, from straight to straight.
  double duration;

  /// the angle at a time (seconds): `angle * cos^2(pi (time - centre_time) / duration)`, zero outside of the duration.
  /// It spends half of the duration above half of the largest angle.
  double angle_at(double time) const
  {
    const double x = (time - centre_time) / duration;
    if (!(std::abs(x) < 0.5)) return 0;
    const double c = std::cos(boost::math::constants::pi<double>() * x);
    return angle * c * c;
  }

  /// the part of the angle that is reached at a place along the axis: a quintic step from 0 below the region to 1
  /// above, so that the curvature of the axis is continuously differentiable.
  double portion_at(double axial) const
  {
    const double x = (std::min)(1., (std::max)(0., (axial - axial_position) / region_length + 0.5));
    return x * x * x * (10 + x * (6 * x - 15));
  }

  /// the largest curvature of the axis (1 / length), at `axial_position` and `centre_time`: 15/8 is the largest slope
  /// of the quintic step.
  double largest_curvature() const { return 1.875 * std::abs(angle) / region_length; }

  /// the standard deviation (length) of the axis' curvature along the axis: of the step's slope 30 x^2 (1-x)^2.
  double axial_deviation() const { return region_length / std::sqrt(28.); }

  /// the standard deviation (seconds) of the angle over time: of a squared cosine.
  double temporal_deviation() const
  {
    const double pi = boost::math::constants::pi<double>();
    return duration * std::sqrt(1. / 12 - 1 / (2 * pi * pi));
  }
};

/*!
Shape, sampling and motion of a cylinder that stands on the origin along +z and bends in the xz-plane.

The defaults are made for detectors of features in space and time: two bends alike in everything but time, the upper
one four times faster than the middle one; 60 frames in 2 s, in which the fast bend takes nine; surface stretched and
compressed by at most a half.
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

/*!
The motion of a bending cylinder: a function of the place on the straight cylinder and of time.

Cross-sections stay plane, rigid and perpendicular to the axis; the axis keeps its length. At the axial place `s` the
axis has turned by \f$\theta(s, t)\f$, the sum of the bends' `angle_at(t) * portion_at(s)`, and has come to
\f$\int_0^s (\sin\theta, 0, \cos\theta)\f$.
*/
class Bending_cylinder_motion
{
public:
  typedef Generated_animation::Kernel::Point_3 Point_3;

  /// a place on the axis and the angle (radians, about +y) of the cross-section there.
  struct Section
  {
    double x, z, angle;
  };

  explicit Bending_cylinder_motion(const std::vector<Cylinder_bend>& bends)
    : m_bends(bends)
  {
    for (const Cylinder_bend& b : m_bends) {
      m_breaks.push_back(b.axial_position - 0.5 * b.region_length);
      m_breaks.push_back(b.axial_position);
      m_breaks.push_back(b.axial_position + 0.5 * b.region_length);
    }
    std::sort(m_breaks.begin(), m_breaks.end());
  }

  /// the angle of the axis at a place along it and a time.
  double angle(double axial, double time) const
  {
    double sum = 0;
    for (const Cylinder_bend& b : m_bends) sum += b.angle_at(time) * b.portion_at(axial);
    return sum;
  }

  /// the cross-section at a place along the axis and a time, exact up to rounding: between two breaks the angle is a
  /// polynomial, and 20 Gauss points then leave no error in double precision.
  Section section(double axial, double time) const
  {
    typedef boost::math::quadrature::gauss<double, 20> Quadrature;
    Section s = {0, 0, angle(axial, time)};
    double from = 0;
    for (std::size_t i = 0; i <= m_breaks.size() && from < axial; ++i) {
      const double to = i < m_breaks.size() ? (std::min)(axial, m_breaks[i]) : axial;
      if (to <= from) continue;
      s.x += Quadrature::integrate([&](double u) { return std::sin(angle(u, time)); }, from, to);
      s.z += Quadrature::integrate([&](double u) { return std::cos(angle(u, time)); }, from, to);
      from = to;
    }
    return s;
  }

  /// where the section carries a point of the straight cylinder.
  static Point_3 place(const Section& s, const Point_3& rest)
  {
    return Point_3(s.x + rest.x() * std::cos(s.angle), rest.y(), s.z - rest.x() * std::sin(s.angle));
  }

  /// where a point of the straight cylinder is at a time.
  Point_3 operator()(const Point_3& rest, double time) const { return place(section(rest.z(), time), rest); }

private:
  std::vector<Cylinder_bend> m_bends;
  std::vector<double> m_breaks;
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

// The number of sextants' parts: a circle has six times as many vertices.
inline std::size_t sixth_of_circle(std::size_t vertices_around)
{
  return (std::max)(std::size_t(1), (vertices_around + 5) / 6);
}

// The number of gaps between rows of vertices, spaced like rows of equilateral triangles.
inline std::size_t number_of_gaps(const Bending_cylinder_options& o)
{
  const double edge =
      boost::math::constants::two_pi<double>() * o.radius / double(6 * sixth_of_circle(o.vertices_around));
  return (std::max)(std::size_t(1), std::size_t(std::lround(o.height / (0.5 * std::sqrt(3.) * edge))));
}

// Adds `n` vertices on a horizontal circle.
inline std::vector<Generated_animation::Mesh::Vertex_index> add_circle(Generated_animation::Mesh& mesh, std::size_t n,
                                                                       double radius, double z, double first_angle)
{
  std::vector<Generated_animation::Mesh::Vertex_index> circle;
  for (std::size_t k = 0; k < n; ++k) {
    const double a = first_angle + boost::math::constants::two_pi<double>() * double(k) / double(n);
    circle.push_back(
        mesh.add_vertex(Generated_animation::Kernel::Point_3(radius * std::cos(a), radius * std::sin(a), z)));
  }
  return circle;
}

// Fills a circle of 6 m vertices with circles of 6 (m-1), ..., 6, 1 vertices: six sectors of a regular triangulation.
inline void add_disc(Generated_animation::Mesh& mesh, std::vector<Generated_animation::Mesh::Vertex_index> outer,
                     double radius, double z, double first_angle, bool faces_up)
{
  auto add_face = [&](auto a, auto b, auto c) { faces_up ? mesh.add_face(a, b, c) : mesh.add_face(a, c, b); };
  const std::size_t m = outer.size() / 6;
  for (std::size_t j = m; j > 0; --j) {
    const auto inner = add_circle(mesh, j == 1 ? 1 : 6 * (j - 1), radius * double(j - 1) / double(m), z, first_angle);
    for (std::size_t sector = 0; sector < 6; ++sector)
      for (std::size_t i = 0; i < j; ++i) {
        const auto o0 = outer[sector * j + i], o1 = outer[(sector * j + i + 1) % outer.size()];
        const auto i0 = inner[(sector * (j - 1) + i) % inner.size()];
        add_face(i0, o0, o1);
        if (i + 1 < j) add_face(i0, o1, inner[(sector * (j - 1) + i + 1) % inner.size()]);
      }
    outer = inner;
  }
}

inline Generated_animation::Mesh straight_cylinder(const Bending_cylinder_options& o)
{
  Generated_animation::Mesh mesh;
  const std::size_t n = 6 * sixth_of_circle(o.vertices_around), gaps = number_of_gaps(o);
  const double half_step = boost::math::constants::pi<double>() / double(n);

  auto lower = add_circle(mesh, n, o.radius, 0, 0);
  const auto foot = lower;
  for (std::size_t row = 0; row < gaps; ++row) {
    // Odd rows are turned by half a step.
    const bool to_odd = row % 2 == 0;
    const auto upper =
        add_circle(mesh, n, o.radius, row + 1 == gaps ? o.height : o.height * double(row + 1) / double(gaps),
                   to_odd ? half_step : 0);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t next = (k + 1) % n;
      mesh.add_face(lower[k], lower[next], upper[to_odd ? k : next]);
      if (to_odd)
        mesh.add_face(lower[next], upper[next], upper[k]);
      else
        mesh.add_face(lower[k], upper[next], upper[k]);
    }
    lower = upper;
  }
  if (o.closed) {
    add_disc(mesh, foot, o.radius, 0, 0, false);
    add_disc(mesh, lower, o.radius, o.height, gaps % 2 == 1 ? half_step : 0, true);
  }
  return mesh;
}

} // namespace internal

/// the number of vertices that `bending_cylinder()` makes.
inline std::size_t number_of_cylinder_vertices(const Bending_cylinder_options& o)
{
  const std::size_t m = internal::sixth_of_circle(o.vertices_around);
  const std::size_t in_disc = 1 + 3 * m * (m - 1);
  return 6 * m * (internal::number_of_gaps(o) + 1) + (o.closed ? 2 * in_disc : 0);
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
  result.mesh = internal::straight_cylinder(options);
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
