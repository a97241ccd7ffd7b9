// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_LEAST_SQUARES_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_LEAST_SQUARES_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Few unknowns from more equations, A x = b, in the sense of least squares: Householder reflections with pivoting of the
// columns (G. H. Golub, C. F. Van Loan, Matrix Computations, sect. 5.4), whose norms are brought up to date as by
// Z. Drmac and Z. Bujanovic (On the failure of rank-revealing QR factorization software, ACM Trans. Math. Softw. 35,
// 2008). If the columns depend on one another, those that the pivoting puts last have the solution 0.
//
// The same operations in the same order as Eigen's class for it with registers of two numbers, hence the same bits, for
// a small part of its time to compile; but with any instructions that the program is compiled for.
template <std::size_t columns>
class Least_squares
{
public:
  typedef std::array<double, columns> Solution;

  // As many equations as unknowns at least, all zero.
  explicit Least_squares(std::size_t equations)
    : m_rows(equations)
    , m_right(equations, 0)
  {
    for (std::vector<double>& column : m_columns) column.assign(equations, 0);
  }

  std::size_t number_of_equations() const { return m_rows; }

  // Sets the i-th equation.
  void set(std::size_t i, const std::array<double, columns>& coefficients, double right)
  {
    for (std::size_t j = 0; j < columns; ++j) m_columns[j][i] = coefficients[j];
    m_right[i] = right;
  }

  // Overwrites the equations.
  Solution solve()
  {
    triangulate();
    Solution x = {};
    for (std::size_t k = 0; k < m_rank; ++k) m_pivot_value[k] = m_right[k];
    for (std::size_t k = m_rank; k-- > 0;) {
      if (m_pivot_value[k] == 0) continue;
      m_pivot_value[k] /= m_columns[k][k];
      for (std::size_t i = 0; i < k; ++i) m_pivot_value[i] -= m_pivot_value[k] * m_columns[k][i];
    }
    for (std::size_t k = 0; k < m_rank; ++k) x[m_unknown[k]] = m_pivot_value[k];
    return x;
  }

private:
  // Makes A an upper triangle, its columns in the order of m_unknown, and reflects b alike.
  void triangulate()
  {
    const double epsilon = std::numeric_limits<double>::epsilon();
    for (std::size_t j = 0; j < columns; ++j) {
      m_unknown[j] = j;
      m_norm[j] = m_measured_norm[j] = norm_from(j, 0);
    }
    // a column that is not longer consists of rounding errors of the longest one
    const double rounding = squared(*std::max_element(m_norm.begin(), m_norm.end()) * epsilon) / double(m_rows);
    m_rank = columns;
    for (std::size_t k = 0; k < columns; ++k) {
      const std::size_t longest = std::size_t(std::max_element(m_norm.begin() + k, m_norm.end()) - m_norm.begin());
      if (m_rank == columns && squared(m_norm[longest]) < rounding * double(m_rows - k)) m_rank = k;
      if (longest != k) {
        m_columns[k].swap(m_columns[longest]);
        std::swap(m_norm[k], m_norm[longest]);
        std::swap(m_measured_norm[k], m_measured_norm[longest]);
        std::swap(m_unknown[k], m_unknown[longest]);
      }
      const double scale = make_reflection(k);
      for (std::size_t j = k + 1; j < columns; ++j) {
        reflect(k, scale, m_columns[j]);
        shorten_norm(k, j);
      }
      if (k < m_rank) reflect(k, scale, m_right);
    }
  }

  // The reflection 1 - scale u u^T that maps column k from its diagonal on to a multiple of the first unit vector. u is 1
  // at the diagonal, and in the place of the column below it.
  double make_reflection(std::size_t k)
  {
    std::vector<double>& column = m_columns[k];
    const double square = k + 1 < m_rows ? sum_of_products(column, column, k + 1) : 0, diagonal = column[k];
    if (square <= (std::numeric_limits<double>::min)()) {
      std::fill(column.begin() + std::ptrdiff_t(k + 1), column.end(), 0.);
      return 0;
    }
    const double length = std::sqrt(diagonal * diagonal + square), image = diagonal >= 0 ? -length : length;
    for (std::size_t i = k + 1; i < m_rows; ++i) column[i] /= diagonal - image;
    column[k] = image;
    return (image - diagonal) / image;
  }

  void reflect(std::size_t k, double scale, std::vector<double>& column) const
  {
    if (scale == 0) return;
    const std::vector<double>& u = m_columns[k];
    const double sum = column[k] + sum_of_products(u, column, k + 1);
    column[k] -= scale * sum;
    for (std::size_t i = k + 1; i < m_rows; ++i) column[i] -= sum * (scale * u[i]);
  }

  // Of what is left of column j below row k.
  void shorten_norm(std::size_t k, std::size_t j)
  {
    if (m_norm[j] == 0) return;
    const double share = std::abs(m_columns[j][k]) / m_norm[j], left = (std::max)(0., (1 + share) * (1 - share));
    if (left * squared(m_norm[j] / m_measured_norm[j]) <= std::sqrt(std::numeric_limits<double>::epsilon()))
      m_norm[j] = m_measured_norm[j] = norm_from(j, k + 1);
    else
      m_norm[j] *= std::sqrt(left);
  }

  double norm_from(std::size_t j, std::size_t first) const
  {
    return first < m_rows ? std::sqrt(sum_of_products(m_columns[j], m_columns[j], first)) : 0;
  }

  // From row `first` on, in four sums, two of which come first where rows are left over: additions need not wait for one
  // another.
  double sum_of_products(const std::vector<double>& a, const std::vector<double>& b, std::size_t first) const
  {
    std::size_t i = first;
    double sum = 0;
    if (i + 4 <= m_rows) {
      double s[4] = {a[i] * b[i], a[i + 1] * b[i + 1], a[i + 2] * b[i + 2], a[i + 3] * b[i + 3]};
      for (i += 4; i + 4 <= m_rows; i += 4)
        for (std::size_t j = 0; j < 4; ++j) s[j] += a[i + j] * b[i + j];
      s[0] += s[2];
      s[1] += s[3];
      if (i + 2 <= m_rows) {
        s[0] += a[i] * b[i];
        s[1] += a[i + 1] * b[i + 1];
        i += 2;
      }
      sum = s[0] + s[1];
    }
    for (; i < m_rows; ++i) sum += a[i] * b[i];
    return sum;
  }

  static double squared(double x) { return x * x; }

  std::size_t m_rows;
  std::array<std::vector<double>, columns> m_columns;
  std::vector<double> m_right;
  std::array<std::size_t, columns> m_unknown;          // of each column
  std::array<double, columns> m_norm, m_measured_norm; // below the rows that are done
  std::array<double, columns> m_pivot_value;
  std::size_t m_rank = 0;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_LEAST_SQUARES_H
