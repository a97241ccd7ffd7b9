// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_INTERNAL_STRAIGHT_CYLINDER_H
#define ANIMATED_MESH_GENERATORS_INTERNAL_STRAIGHT_CYLINDER_H

#include "../Generated_animation.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Animated_mesh_generators {
namespace internal {

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

/// A cylinder along +z from the origin, in near-equilateral triangles: rows of vertices with every other row turned by
/// half a step, and regular discs if it is closed.
struct Straight_cylinder
{
  double radius, height;
  bool closed;
  /// a circle has six times as many vertices.
  std::size_t sixth_of_circle;

  Straight_cylinder(double radius, double height, bool closed, std::size_t vertices_around)
    : radius(radius)
    , height(height)
    , closed(closed)
    , sixth_of_circle((std::max)(std::size_t(1), (vertices_around + 5) / 6))
  {}

  std::size_t vertices_around() const { return 6 * sixth_of_circle; }

  /// the number of gaps between rows, which are as far apart as rows of equilateral triangles.
  std::size_t gaps() const
  {
    const double edge = boost::math::constants::two_pi<double>() * radius / double(vertices_around());
    return (std::max)(std::size_t(1), std::size_t(std::lround(height / (0.5 * std::sqrt(3.) * edge))));
  }

  std::size_t number_of_vertices() const
  {
    const std::size_t in_disc = 1 + 3 * sixth_of_circle * (sixth_of_circle - 1);
    return vertices_around() * (gaps() + 1) + (closed ? 2 * in_disc : 0);
  }

  Generated_animation::Mesh mesh() const
  {
    Generated_animation::Mesh result;
    const std::size_t n = vertices_around();
    const double half_step = boost::math::constants::pi<double>() / double(n);
    const auto foot = add_circle(result, n, radius, 0, 0);
    auto lower = foot;
    for (std::size_t row = 1; row <= gaps(); ++row) {
      const bool odd = row % 2 == 1;
      const double z = height * (double(row) / double(gaps()));
      const auto upper = add_circle(result, n, radius, z, odd ? half_step : 0);
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t next = (k + 1) % n;
        result.add_face(lower[k], lower[next], upper[odd ? k : next]);
        result.add_face(lower[odd ? next : k], upper[next], upper[k]);
      }
      lower = upper;
    }
    if (closed) {
      add_disc(result, foot, radius, 0, 0, false);
      add_disc(result, lower, radius, height, gaps() % 2 == 1 ? half_step : 0, true);
    }
    return result;
  }
};

} // namespace internal
} // namespace Animated_mesh_generators

#endif // ANIMATED_MESH_GENERATORS_INTERNAL_STRAIGHT_CYLINDER_H
