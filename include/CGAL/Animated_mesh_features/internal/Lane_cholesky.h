// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_LANE_CHOLESKY_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_LANE_CHOLESKY_H

#include <CGAL/Animated_mesh_features/exceptions.h>
#include <CGAL/Animated_mesh_features/internal/Frame_block.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A sparse Cholesky factorisation whose triangular solves take one right-hand side in each lane of a vector register:
// each entry of the factor is loaded once for all of them. The factor is computed in double, by Eigen.
class Lane_cholesky
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;

  // The fill-reducing ordering depends on the pattern only: once for matrices that differ in their values.
  void analyze(const Matrix& a) { m_solver.analyzePattern(a); }

  void factorize(const Matrix& a)
  {
    m_solver.factorize(a);
    if (m_solver.info() != Eigen::Success)
      throw Numerical_error("the Cholesky factorisation failed: the matrix is not positive definite");
  }

  // Number in the factor of the i-th row of the matrix.
  std::size_t position(std::size_t i) const { return std::size_t(m_solver.permutationP().indices()[Eigen::Index(i)]); }

  // Solves in place; x in the order of the factor.
  template <class FT>
  void solve(std::vector<typename Frame_block<FT>::Array>& x) const
  {
    typedef typename Frame_block<FT>::Array Array;
    const auto& factor = m_solver.matrixL().nestedExpression();
    const double* values = factor.valuePtr();
    const auto* rows = factor.innerIndexPtr();
    const auto* columns = factor.outerIndexPtr();
    const std::ptrdiff_t n = factor.cols();
    for (std::ptrdiff_t j = 0; j < n; ++j) { // the diagonal is the first entry of its column
      const auto first = columns[j];
      const Array xj = x[j] * FT(1 / values[first]);
      x[j] = xj;
      for (auto p = first + 1; p < columns[j + 1]; ++p) x[rows[p]] -= xj * FT(values[p]);
    }
    for (std::ptrdiff_t j = n - 1; j >= 0; --j) {
      const auto first = columns[j];
      Array xj = x[j];
      for (auto p = first + 1; p < columns[j + 1]; ++p) xj -= x[rows[p]] * FT(values[p]);
      x[j] = xj * FT(1 / values[first]);
    }
  }

private:
  Eigen::SimplicialLLT<Matrix> m_solver;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_LANE_CHOLESKY_H
