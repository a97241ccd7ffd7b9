// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_BENDING_CYLINDER_MOTION_H
#define ANIMATED_MESH_GENERATORS_BENDING_CYLINDER_MOTION_H

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

} // namespace Animated_mesh_generators

#endif // ANIMATED_MESH_GENERATORS_BENDING_CYLINDER_MOTION_H
