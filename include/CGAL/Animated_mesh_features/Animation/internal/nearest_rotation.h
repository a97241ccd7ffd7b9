// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_NEAREST_ROTATION_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_NEAREST_ROTATION_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Packed_vector.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/pack_math.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Turns rows and columns p and q of a symmetric matrix so that its entry there becomes zero, and columns of `v`, which
// gathers the turns; G. H. Golub, C. F. Van Loan, Matrix Computations, sect. 8.5.
inline void jacobi_rotation(double (&a)[4][4], double (&v)[4][4], int p, int q)
{
  if (a[p][q] == 0) return;
  const double tau = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = (tau < 0 ? -1 : 1) / (std::abs(tau) + std::sqrt(1 + tau * tau));
  const double c = 1 / std::sqrt(1 + t * t), s = t * c;
  const auto turn = [c, s](double& x, double& y) {
    const double old = x;
    x = c * old - s * y;
    y = s * old + c * y;
  };
  for (int i = 0; i < 4; ++i) turn(a[i][p], a[i][q]);
  for (int i = 0; i < 4; ++i) turn(a[p][i], a[q][i]);
  for (int i = 0; i < 4; ++i) turn(v[i][p], v[i][q]);
}

// The rotation R that maximises trace(R^T m), hence is nearest to `m`, whatever m is: the eigenvector of the largest
// eigenvalue of a symmetric matrix is its quaternion; B. K. P. Horn, Closed-form solution of absolute orientation using
// unit quaternions, J. Opt. Soc. Am. A 4(4), 1987. Never a reflection.
CGAL_ANIMATED_MESH_FEATURES_NO_INLINE inline Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& m)
{
  const int most_sweeps = 20; // convergence is quadratic: 4 to 6 are enough
  double a[4][4] = {{m(0, 0) + m(1, 1) + m(2, 2), m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)},
                    {0, m(0, 0) - m(1, 1) - m(2, 2), m(0, 1) + m(1, 0), m(0, 2) + m(2, 0)},
                    {0, 0, m(1, 1) - m(0, 0) - m(2, 2), m(1, 2) + m(2, 1)},
                    {0, 0, 0, m(2, 2) - m(0, 0) - m(1, 1)}};
  double v[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) a[i][j] = a[j][i];
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double off = 0, all = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        all += std::abs(a[i][j]);
        if (i != j) off += std::abs(a[i][j]);
      }
    if (!(off > std::numeric_limits<double>::epsilon() / 4 * all)) break;
    for (int p = 0; p < 3; ++p)
      for (int q = p + 1; q < 4; ++q) jacobi_rotation(a, v, p, q);
  }
  int largest = 0;
  for (int i = 1; i < 4; ++i)
    if (a[i][i] > a[largest][largest]) largest = i;
  return Eigen::Quaterniond(v[0][largest], v[1][largest], v[2][largest], v[3][largest]).normalized().toRotationMatrix();
}

// Matrices that are computed with together: entry (row, column) of the i-th one is at [3 * column + row][i].
constexpr std::size_t matrices_at_once = 8;
typedef double Matrix_group[9][matrices_at_once];

template <class L>
struct Packed_matrix
{
  Packed_vector<L> columns[3];
};

// One step of Newton's iteration for the polar factor, the mean of a matrix and its inverse transpose, which is that of
// the cofactors by the determinant; N. J. Higham, Computing the polar decomposition, SIAM J. Sci. Stat. Comput. 7(4),
// 1986, eq. (3.1).
template <class L>
CGAL_ANIMATED_MESH_FEATURES_INLINE Packed_matrix<L> polar_step(const Packed_matrix<L>& q)
{
  const auto& c = q.columns;
  const Packed_vector<L> x = c[1].cross(c[2]), y = c[2].cross(c[0]), z = c[0].cross(c[1]);
  const L half = L::all(0.5) / c[0].dot(x);
  return {{c[0] * 0.5 + x * half, c[1] * 0.5 + y * half, c[2] * 0.5 + z * half}};
}

// Replaces each matrix by the nearest rotation: by Newton's iteration, and where a matrix is nearly singular or a
// reflection, as above.
template <class L>
CGAL_ANIMATED_MESH_FEATURES_INLINE void nearest_rotations(Matrix_group& m)
{
  // det / norm^3 is 3^(-3/2) = 0.19 for a rotation; below a thousandth of that Newton's iteration would be slow.
  const double far_from_singular = 2e-4;
  const int most_steps = 20; // a handful is enough
  Packed_matrix<L> q;
  for (int k = 0; k < 3; ++k) q.columns[k] = {L::load(m[3 * k]), L::load(m[3 * k + 1]), L::load(m[3 * k + 2])};
  const auto& c = q.columns;
  const L norm = sqrt(c[0].dot(c[0]) + c[1].dot(c[1]) + c[2].dot(c[2]));
  const L excess = c[0].dot(c[1].cross(c[2])) - norm * norm * norm * far_from_singular, zero = L::all(0);
  const L factor = where_greater(excess, zero, L::all(std::sqrt(3.)) / norm, zero);
  for (int k = 0; k < 3; ++k) {
    // the identity, where there will be another way
    L* const column[3] = {&q.columns[k].x, &q.columns[k].y, &q.columns[k].z};
    for (int i = 0; i < 3; ++i)
      *column[i] = where_greater(excess, zero, *column[i] * factor, L::all(i == k ? 1. : 0.));
  }
  double is_regular[matrices_at_once], changes[matrices_at_once];
  excess.store(is_regular);
  for (int step = 0; step < most_steps; ++step) {
    const Packed_matrix<L> next = polar_step(q);
    L change = zero;
    for (int k = 0; k < 3; ++k) {
      const Packed_vector<L> d = next.columns[k] - q.columns[k];
      change = change + d.dot(d);
    }
    q = next;
    change.store(changes);
    // quadratic convergence: the error that is left is about half of the square of the change, below rounding
    if (*std::max_element(changes, changes + matrices_at_once) < std::numeric_limits<double>::epsilon()) break;
  }
  for (std::size_t i = 0; i < matrices_at_once; ++i) {
    if (is_regular[i] > 0 && changes[i] < std::numeric_limits<double>::epsilon()) continue;
    Eigen::Matrix3d single;
    for (int k = 0; k < 9; ++k) single(k % 3, k / 3) = m[k][i];
    single = nearest_rotation(single);
    for (int k = 0; k < 9; ++k) m[k][i] = single(k % 3, k / 3);
    is_regular[i] = 0;
  }
  for (int k = 0; k < 3; ++k) {
    const L* const column[3] = {&q.columns[k].x, &q.columns[k].y, &q.columns[k].z};
    for (int r = 0; r < 3; ++r) {
      const L regular = L::load(is_regular);
      where_greater(regular, zero, *column[r], L::load(m[3 * k + r])).store(m[3 * k + r]);
    }
  }
}

// `points` moved rigidly to where they fit `target` best in the sense of least squares; Horn as above.
inline std::vector<Eigen::Vector3d> fitted_rigidly(const std::vector<Eigen::Vector3d>& points,
                                                   const std::vector<Eigen::Vector3d>& target)
{
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = from;
  for (std::size_t i = 0; i < points.size(); ++i) {
    from += points[i];
    to += target[i];
  }
  from /= double(points.size());
  to /= double(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) covariance += (target[i] - to) * (points[i] - from).transpose();
  const Eigen::Matrix3d r = nearest_rotation(covariance);
  std::vector<Eigen::Vector3d> moved(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) moved[i] = r * (points[i] - from) + to;
  return moved;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_NEAREST_ROTATION_H
