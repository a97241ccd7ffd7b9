// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The rotation nearest to a matrix, one at a time and in groups, against Eigen's singular values: of matrices in general,
// near rotations, of rank 2, 1 and 0, and reflections.

#include "test_support.h"

#include <CGAL/Animated_mesh_features/Animation/internal/nearest_rotation.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>

#include <Eigen/Dense>

#include <cstddef>
#include <random>
#include <vector>

namespace internal = CGAL::Animated_mesh_features::internal;
typedef Eigen::Matrix3d Matrix;

// W. Kabsch, A discussion of the solution for the best rotation to relate two sets of vectors, Acta Cryst. A34, 1978.
Matrix by_singular_values(const Matrix& m)
{
  const Eigen::JacobiSVD<Matrix> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) = -u.col(2);
  return u * svd.matrixV().transpose();
}

struct Group_loop
{
  internal::Matrix_group& group;
  template <std::size_t register_bytes>
  void run()
  {
    internal::nearest_rotations<internal::Pack<double, internal::matrices_at_once, register_bytes>>(group);
  }
};

// All of them, in groups.
std::vector<Matrix> in_groups(const std::vector<Matrix>& matrices, internal::Instruction_set instructions)
{
  std::vector<Matrix> result(matrices.size());
  for (std::size_t first = 0; first < matrices.size(); first += internal::matrices_at_once) {
    internal::Matrix_group group;
    for (std::size_t i = 0; i < internal::matrices_at_once; ++i)
      for (std::size_t k = 0; k < 9; ++k) group[k][i] = matrices[(first + i) % matrices.size()].data()[k];
    Group_loop loop{group};
    internal::run_reproducibly<double>(instructions, loop);
    for (std::size_t i = 0; i < internal::matrices_at_once && first + i < matrices.size(); ++i)
      for (std::size_t k = 0; k < 9; ++k) result[first + i].data()[k] = group[k][i];
  }
  return result;
}

// It is a rotation, and none fits better: the traces agree where rotations need not, as of matrices of rank 1.
void check_rotation(const Matrix& r, const Matrix& m)
{
  const double scale = m.norm();
  CHECK((r * r.transpose() - Matrix::Identity()).norm() < 1e-14 && r.determinant() > 0);
  CHECK((r.transpose() * m).trace() >= (by_singular_values(m).transpose() * m).trace() - 1e-14 * scale);
}

int main()
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto any = [&] { return Matrix(Matrix::NullaryExpr([&] { return normal(random); })); };
  std::vector<Matrix> matrices;
  for (int i = 0; i < 300; ++i) {
    Matrix m = any();
    const Matrix r = by_singular_values(any());
    switch (i % 6) {
    case 0: break; // one half of them with a negative determinant
    case 1: m = r + 1e-3 * m; break;
    case 2: m.col(2).setZero(); break;
    case 3: m = m.col(0) * m.row(1); break;
    case 4: m = -r; break;
    default: m = r * (i % 2 == 0 ? 1e60 : 1e-60);
    }
    matrices.push_back(m);
  }
  matrices.push_back(Matrix::Zero());
  const std::vector<Matrix> grouped = in_groups(matrices, internal::widest_instruction_set());
  CHECK(grouped == in_groups(matrices, internal::Instruction_set::BASELINE));
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    check_rotation(grouped[i], matrices[i]);
    check_rotation(internal::nearest_rotation(matrices[i]), matrices[i]);
    if (i % 6 == 1) CHECK((grouped[i] - by_singular_values(matrices[i])).norm() < 1e-14);
  }
  return test_support::test_result();
}
