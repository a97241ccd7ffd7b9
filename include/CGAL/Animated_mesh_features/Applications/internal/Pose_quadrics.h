// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSE_QUADRICS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSE_QUADRICS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_positions.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Quadric.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// For each vertex and pose a quadric (M. Garland, P. S. Heckbert, Surface simplification using quadric error metrics,
// 1997); of an edge, the sum over poses of the least value that the sum of its ends' quadrics takes (A. Mohr, M.
// Gleicher, Deformation sensitive decimation, 2003).
//
// The ten coefficients of a vertex are rows of poses: loops run over poses.
class Pose_quadrics
{
public:
  Pose_quadrics() = default;
  Pose_quadrics(std::size_t vertices, std::size_t poses)
    : m_poses(poses)
    , m_values(vertices * size * poses, 0.)
  {}

  std::size_t number_of_poses() const { return m_poses; }
  double* of(std::size_t v) { return m_values.data() + v * size * m_poses; }
  const double* of(std::size_t v) const { return m_values.data() + v * size * m_poses; }

  // of an edge: the sum of its ends'
  Quadric sum(std::size_t i, std::size_t j, std::size_t pose) const
  {
    const double *const q = of(i) + pose, *const r = of(j) + pose;
    Quadric s;
    for (std::size_t k = 0; k < size; ++k) s[k] = q[k * m_poses] + r[k * m_poses];
    return s;
  }

  // adds the quadric of another vertex.
  void add(std::size_t to, std::size_t from)
  {
    double* const t = of(to);
    const double* const f = of(from);
    for (std::size_t i = 0; i < size * m_poses; ++i) t[i] += f[i];
  }

  // adds the squared distance from the plane through p with the unit normal n, times a weight.
  void add_plane(std::size_t v, std::size_t pose, const Rest_shape::Point& n, const Rest_shape::Point& p, double weight)
  {
    const double d = -n.dot(p);
    add(v, pose,
        {{n[0] * n[0], n[0] * n[1], n[0] * n[2], n[1] * n[1], n[1] * n[2], n[2] * n[2], n[0] * d, n[1] * d, n[2] * d,
          d * d}},
        weight);
  }

  // adds the squared distance from the line through p along the unit vector n, times a weight.
  void add_line(std::size_t v, std::size_t pose, const Rest_shape::Point& n, const Rest_shape::Point& p, double weight)
  {
    const double along = n.dot(p);
    const Rest_shape::Point b = along * n - p;
    add(v, pose,
        {{1 - n[0] * n[0], -n[0] * n[1], -n[0] * n[2], 1 - n[1] * n[1], -n[1] * n[2], 1 - n[2] * n[2], b[0], b[1], b[2],
          p.squaredNorm() - along * along}},
        weight);
  }

  // The cost of an edge: in each pose the least value of the summed quadric, about the middle of the edge; where that
  // is badly determined, in a plane or along a crease, the point near the middle. The step from the middle is that of
  // a matrix which is made definite by a small multiple of its trace, and no longer than the edge.
  double cost(std::size_t i, std::size_t j, const Pose_positions& positions) const
  {
    const double *const q = of(i), *const r = of(j);
    const std::size_t n = m_poses;
    const float *const x0 = positions.row(i, 0), *const y0 = positions.row(i, 1), *const z0 = positions.row(i, 2);
    const float *const x1 = positions.row(j, 0), *const y1 = positions.row(j, 1), *const z1 = positions.row(j, 2);
    double sum = 0;
    for (std::size_t p = 0; p < n; ++p) {
      const double xx = q[p] + r[p], xy = q[n + p] + r[n + p], xz = q[2 * n + p] + r[2 * n + p],
                   yy = q[3 * n + p] + r[3 * n + p], yz = q[4 * n + p] + r[4 * n + p], zz = q[5 * n + p] + r[5 * n + p],
                   bx = q[6 * n + p] + r[6 * n + p], by = q[7 * n + p] + r[7 * n + p], bz = q[8 * n + p] + r[8 * n + p],
                   c = q[9 * n + p] + r[9 * n + p];
      const double x = (double(x0[p]) + double(x1[p])) / 2, y = (double(y0[p]) + double(y1[p])) / 2,
                   z = (double(z0[p]) + double(z1[p])) / 2;
      const double dx = double(x1[p]) - double(x0[p]), dy = double(y1[p]) - double(y0[p]),
                   dz = double(z1[p]) - double(z0[p]);
      const double gx = xx * x + xy * y + xz * z + bx, gy = xy * x + yy * y + yz * z + by,
                   gz = xz * x + yz * y + zz * z + bz;
      const double middle = x * (gx + bx) + y * (gy + by) + z * (gz + bz) + c;
      const double small = regularisation * (xx + yy + zz) + 1e-300;
      // L D L^T of three rows
      const double d0 = xx + small, l1 = xy / d0, l2 = xz / d0, d1 = yy + small - l1 * xy, m = yz - l1 * xz,
                   l3 = m / d1, d2 = zz + small - l2 * xz - l3 * m;
      const double u0 = gx, u1 = gy - l1 * u0, u2 = gz - l2 * u0 - l3 * u1;
      const double s2 = u2 / d2, s1 = u1 / d1 - l3 * s2, s0 = u0 / d0 - l1 * s1 - l2 * s2;
      // the step is -s
      const double length = s0 * s0 + s1 * s1 + s2 * s2, most = dx * dx + dy * dy + dz * dz;
      const double gs = gx * s0 + gy * s1 + gz * s2;
      const double t = length > most ? std::sqrt(most / length) : 1.;
      const double value = middle - 2 * t * gs + t * t * (gs - small * length);
      sum += value > 0 ? value : 0;
    }
    return sum;
  }

  static constexpr double regularisation = 1e-3; // of the trace

private:
  static constexpr std::size_t size = std::tuple_size<Quadric>::value;

  void add(std::size_t v, std::size_t pose, const Quadric& q, double weight)
  {
    double* const t = of(v) + pose;
    for (std::size_t i = 0; i < size; ++i) t[i * m_poses] += weight * q[i];
  }

  std::size_t m_poses = 0;
  std::vector<double> m_values;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSE_QUADRICS_H
