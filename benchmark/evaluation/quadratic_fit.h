// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_QUADRATIC_FIT_H
#define ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_QUADRATIC_FIT_H

#include <Eigen/Core>
#include <Eigen/QR>

#include <optional>
#include <vector>

namespace Static_detectors {

// z = p[0] / 2 x^2 + p[1] x y + p[2] / 2 y^2 + p[3] x + p[4] y + p[5] by least squares; none if the points do not
// tell. x and y should be of the order of 1.
inline std::optional<Eigen::Matrix<double, 6, 1>> quadratic_fit(const std::vector<Eigen::Vector3d>& points)
{
  typedef Eigen::Matrix<double, 6, 1> Vector;
  typedef Eigen::Matrix<double, 6, 6> Matrix;
  Matrix matrix = Matrix::Zero();
  Vector right = Vector::Zero();
  for (const Eigen::Vector3d& p : points) {
    Vector row;
    row << p[0] * p[0] / 2, p[0] * p[1], p[1] * p[1] / 2, p[0], p[1], 1;
    matrix += row * row.transpose();
    right += p[2] * row;
  }
  Eigen::ColPivHouseholderQR<Matrix> qr(matrix);
  qr.setThreshold(1e-10);
  if (qr.rank() < 6) return std::nullopt;
  return Vector(qr.solve(right));
}

} // namespace Static_detectors

#endif // ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_QUADRATIC_FIT_H
