// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_REFINE_EXTREMUM_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_REFINE_EXTREMUM_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Extremum.h>
#include <CGAL/Animated_mesh_features/Numerics/Least_squares.h>
#include <CGAL/Animated_mesh_features/Numerics/Small_cholesky.h>
#include <CGAL/Animated_mesh_features/Numerics/all_finite.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// An extremum of the quadratic through the samples around a grid extremum.
struct Refined_scales
{
  double space_level, time_level, frame; // offsets from the grid, within [-1/2, 1/2]
  double response;
};

// Space level, time level and frame together: the second differences of the 3 x 3 x 3 window, mixed ones included,
// since the two scales are correlated. Where that quadratic has no extremum close by, each direction by its own
// parabola.
inline Refined_scales refine_scales(const Extremum& e)
{
  const auto d = [&](int i, int j, int m) { return e.window[i + 1][j + 1][m + 1]; };
  const double centre = d(0, 0, 0);
  const std::array<double, 3> gradient = {
      {(d(1, 0, 0) - d(-1, 0, 0)) / 2, (d(0, 1, 0) - d(0, -1, 0)) / 2, (d(0, 0, 1) - d(0, 0, -1)) / 2}};
  Small_cholesky<3>::Matrix hessian; // up to its diagonal
  hessian[0][0] = d(1, 0, 0) + d(-1, 0, 0) - 2 * centre;
  hessian[1][1] = d(0, 1, 0) + d(0, -1, 0) - 2 * centre;
  hessian[2][2] = d(0, 0, 1) + d(0, 0, -1) - 2 * centre;
  hessian[1][0] = (d(1, 1, 0) - d(1, -1, 0) - d(-1, 1, 0) + d(-1, -1, 0)) / 4;
  hessian[2][0] = (d(1, 0, 1) - d(1, 0, -1) - d(-1, 0, 1) + d(-1, 0, -1)) / 4;
  hessian[2][1] = (d(0, 1, 1) - d(0, 1, -1) - d(0, -1, 1) + d(0, -1, -1)) / 4;
  std::array<double, 3> offset = {{0, 0, 0}};
  const Small_cholesky<3> factor(hessian);
  bool is_close = factor.is_definite();
  if (is_close) {
    const std::array<double, 3> uphill = factor.solve(gradient);
    for (std::size_t i = 0; i < 3; ++i) {
      offset[i] = -uphill[i];
      is_close = is_close && std::abs(offset[i]) <= 0.5;
    }
  }
  if (!is_close)
    for (std::size_t i = 0; i < 3; ++i)
      offset[i] = hessian[i][i] != 0 ? std::max(-0.5, std::min(0.5, -gradient[i] / hessian[i][i])) : 0;
  const double slope = gradient[0] * offset[0] + gradient[1] * offset[1] + gradient[2] * offset[2];
  return {offset[0], offset[1], offset[2], centre + slope / 2};
}

// The value at position `offset` between samples of a scale at three levels, quadratic in the logarithm.
inline double interpolated_scale(double before, double at, double after, double offset)
{
  if (!(before > 0)) return at * std::pow(after / at, offset); // the unsmoothed level has scale 0
  const double a = std::log(before / at), b = std::log(after / at);
  return at * std::exp(offset * (b - a) / 2 + offset * offset * (a + b) / 2);
}

// A point in a triangle at the vertex.
struct Refined_place
{
  std::array<std::size_t, 3> triangle;
  std::array<double, 3> barycentric;
};

// The place of a vertex itself.
inline Refined_place place_of_vertex(const Rest_shape& shape, std::size_t v)
{
  Refined_place place = {{{v, v, v}}, {{1, 0, 0}}};
  if (shape.incident_triangles()[v].empty()) return place;
  const Rest_shape::Triangle& t = shape.triangles()[shape.incident_triangles()[v].front()];
  for (int i = 0; i < 3; ++i) {
    place.triangle[i] = t[i];
    place.barycentric[i] = t[i] == v ? 1 : 0;
  }
  return place;
}

// On the surface: least squares fit of a quadratic, through the response at the vertex, to the responses at its
// neighbours in the tangent plane, where they keep their distances. The minimum is carried to the triangle in whose
// sector it lies.
inline Refined_place refine_place(const Rest_shape& shape, const Extremum& e)
{
  const std::size_t v = e.vertex;
  Refined_place place = place_of_vertex(shape, v);
  const auto ring = shape.neighbours()[v];
  if (ring.size() < 5) return place; // a quadratic has five coefficients besides its value
  const Rest_shape::Point origin = shape.points()[v];
  Rest_shape::Point normal = Rest_shape::Point::Zero();
  for (Rest_shape::Index t : shape.incident_triangles()[v]) {
    const Rest_shape::Triangle& c = shape.triangles()[t];
    normal += (shape.points()[c[1]] - shape.points()[c[0]]).cross(shape.points()[c[2]] - shape.points()[c[0]]);
  }
  if (!(normal.norm() > 0)) return place;
  normal.normalize();
  const Rest_shape::Point axis_1 = normal.unitOrthogonal(), axis_2 = normal.cross(axis_1);
  const auto flat = [&](std::size_t w) -> std::array<double, 2> {
    const Rest_shape::Point p = shape.points()[w] - origin;
    const double x = p.dot(axis_1), y = p.dot(axis_2), norm = std::sqrt(x * x + y * y);
    const double scale = norm > 0 ? p.norm() / norm : 1;
    return {{x * scale, y * scale}};
  };
  Least_squares<5> equations(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::array<double, 2> q = flat(ring[i]);
    // each equation over its squared distance, by which the error of the quadratic grows
    const double weight = 1 / (std::max)(q[0] * q[0] + q[1] * q[1], 1e-300);
    equations.set(
        i, {{q[0] * weight, q[1] * weight, q[0] * q[0] / 2 * weight, q[0] * q[1] * weight, q[1] * q[1] / 2 * weight}},
        (e.ring[i] - e.response()) * weight);
  }
  const std::array<double, 5> x = equations.solve();
  const Small_cholesky<2> hessian({{{{x[2], x[3]}}, {{x[3], x[4]}}}});
  if (!all_finite(x.data(), x.size()) || !hessian.is_definite()) return place;
  const std::array<double, 2> uphill = hessian.solve({{x[0], x[1]}}), minimum = {{-uphill[0], -uphill[1]}};
  for (Rest_shape::Index t : shape.incident_triangles()[v]) {
    const Rest_shape::Triangle& c = shape.triangles()[t];
    const int i = int(std::find(c.begin(), c.end(), Rest_shape::Index(v)) - c.begin());
    const std::size_t p = c[(i + 1) % 3], q = c[(i + 2) % 3];
    const std::array<double, 2> to_p = flat(p), to_q = flat(q);
    const double area = to_p[0] * to_q[1] - to_p[1] * to_q[0]; // twice
    if (!(std::abs(area) > 0)) continue;
    const double inverse = 1 / area;
    std::array<double, 2> s = {{to_q[1] * inverse * minimum[0] + -to_q[0] * inverse * minimum[1],
                                -to_p[1] * inverse * minimum[0] + to_p[0] * inverse * minimum[1]}};
    if (!(s[0] >= 0 && s[1] >= 0)) continue;
    // The vertex is the smallest sample: the minimum is nearer to it than to its neighbours.
    const double sum = s[0] + s[1];
    if (sum > 0.5)
      for (double& weight : s) weight *= 0.5 / sum;
    place.triangle = {{v, p, q}};
    place.barycentric = {{1 - s[0] - s[1], s[0], s[1]}};
    break;
  }
  return place;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_REFINE_EXTREMUM_H
