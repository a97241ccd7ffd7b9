// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SMALL_CHOLESKY_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SMALL_CHOLESKY_H

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The factorisation A = L L^T of a symmetric matrix of 2 or 3 rows, row by row as in G. H. Golub, C. F. Van Loan, Matrix
// Computations, sect. 4.2. Eigen's is as quick and has the same bits, but costs seconds to compile wherever it is
// included.
template <std::size_t n>
class Small_cholesky
{
  static_assert(n == 2 || n == 3, "unrolled by the compiler; a sum of more than two products would have an order");

public:
  typedef std::array<double, n> Vector;
  typedef std::array<Vector, n> Matrix; // rows, of which those parts up to the diagonal are read

  explicit Small_cholesky(const Matrix& a)
    : m_l(a)
  {
    for (std::size_t k = 0; k < n; ++k) {
      const double pivot = m_l[k][k] - product(k, k, k);
      if (!(pivot > 0)) return;
      m_l[k][k] = std::sqrt(pivot);
      for (std::size_t i = k + 1; i < n; ++i) m_l[i][k] = (m_l[i][k] - product(i, k, k)) / m_l[k][k];
    }
    m_is_definite = true;
  }

  // Whether the matrix is positive definite; there is no solution else.
  bool is_definite() const { return m_is_definite; }

  // x with A x = b.
  Vector solve(Vector b) const
  {
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < i; ++j) sum += m_l[i][j] * b[j];
      b[i] = (b[i] - sum) / m_l[i][i];
    }
    for (std::size_t i = n; i-- > 0;) {
      double sum = 0;
      for (std::size_t j = i + 1; j < n; ++j) sum += m_l[j][i] * b[j];
      b[i] = (b[i] - sum) / m_l[i][i];
    }
    return b;
  }

private:
  // of the first `size` entries of two rows
  double product(std::size_t row_1, std::size_t row_2, std::size_t size) const
  {
    double sum = 0;
    for (std::size_t j = 0; j < size; ++j) sum += m_l[row_1][j] * m_l[row_2][j];
    return sum;
  }

  Matrix m_l;
  bool m_is_definite = false;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SMALL_CHOLESKY_H
