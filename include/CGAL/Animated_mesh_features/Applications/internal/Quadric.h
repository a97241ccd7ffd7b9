// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_QUADRIC_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_QUADRIC_H

#include <array>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// x^T A x + 2 b^T x + c: A (xx, xy, xz, yy, yz, zz), b (x, y, z), c.
typedef std::array<double, 10> Quadric;

// A x
inline std::array<double, 3> product(const Quadric& q, const std::array<double, 3>& x)
{
  return {{q[0] * x[0] + q[1] * x[1] + q[2] * x[2], q[1] * x[0] + q[3] * x[1] + q[4] * x[2],
           q[2] * x[0] + q[4] * x[1] + q[5] * x[2]}};
}

// A x + b
inline std::array<double, 3> half_gradient(const Quadric& q, const std::array<double, 3>& x)
{
  std::array<double, 3> g = product(q, x);
  for (std::size_t k = 0; k < 3; ++k) g[k] += q[6 + k];
  return g;
}

inline double value(const Quadric& q, const std::array<double, 3>& x)
{
  const std::array<double, 3> g = half_gradient(q, x);
  double sum = q[9];
  for (std::size_t k = 0; k < 3; ++k) sum += x[k] * (g[k] + q[6 + k]);
  return sum;
}

inline double trace(const Quadric& q)
{
  return q[0] + q[3] + q[5];
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_QUADRIC_H
