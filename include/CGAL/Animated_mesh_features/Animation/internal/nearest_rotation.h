// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_NEAREST_ROTATION_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_NEAREST_ROTATION_H

#include <Eigen/Dense>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The rotation R that maximises trace(R^T m), hence is nearest to `m`, by singular values; W. Kabsch, A discussion of
// the solution for the best rotation to relate two sets of vectors, Acta Cryst. A34, 1978. Never a reflection.
inline Eigen::Matrix3d nearest_rotation_svd(const Eigen::Matrix3d& m)
{
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) = -u.col(2); // singular values descend
  return u * svd.matrixV().transpose();
}

// The same, but faster where `m` is far from singular: Newton's iteration for the polar factor, N. J. Higham, Computing
// the polar decomposition, SIAM J. Sci. Stat. Comput. 7(4), 1986, eq. (3.1).
inline Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& m)
{
  // det / norm^3 is 3^(-3/2) = 0.19 for a rotation; below a thousandth of that Newton's iteration would be slow.
  const double far_from_singular = 2e-4;
  const int most_steps = 20; // a handful is enough
  const double norm = m.norm();
  if (!(m.determinant() > far_from_singular * norm * norm * norm)) return nearest_rotation_svd(m);
  Eigen::Matrix3d q = m * (std::sqrt(3.) / norm);
  for (int i = 0; i < most_steps; ++i) {
    const Eigen::Matrix3d next = (q + q.inverse().transpose()) / 2;
    const double change = (next - q).squaredNorm();
    q = next;
    // quadratic convergence: the step that would follow is below rounding
    if (change < std::numeric_limits<double>::epsilon()) return (q + q.inverse().transpose()) / 2;
  }
  return nearest_rotation_svd(m);
}

// `points` moved rigidly to where they fit `target` best in the sense of least squares; Kabsch as above.
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
  const Eigen::Matrix3d r = nearest_rotation_svd(covariance);
  std::vector<Eigen::Vector3d> moved(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) moved[i] = r * (points[i] - from) + to;
  return moved;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_NEAREST_ROTATION_H
