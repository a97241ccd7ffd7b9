// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_SOLVE_DEFINITE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_SOLVE_DEFINITE_H

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Solves A x = b for a symmetric positive definite matrix of a few dozen rows, by A = L D L^T (G. H. Golub, C. F. Van
// Loan, Matrix Computations, sect. 4.1). `a`: `n x n`, row after row, of which the lower triangle is read and
// overwritten; `b` becomes x. Returns whether the matrix is definite; `b` is then of no use else.
inline bool solve_definite(std::vector<double>& a, std::vector<double>& b, std::size_t n)
{
  for (std::size_t j = 0; j < n; ++j) {
    double* const row = a.data() + j * n;
    for (std::size_t i = 0; i < j; ++i) {
      const double* const other = a.data() + i * n;
      double sum = row[i];
      for (std::size_t k = 0; k < i; ++k) sum -= row[k] * other[k];
      row[i] = sum; // L D for now
    }
    double pivot = row[j];
    for (std::size_t i = 0; i < j; ++i) {
      const double l = row[i] / a[i * n + i];
      pivot -= l * row[i];
      row[i] = l;
    }
    if (!(pivot > 0)) return false;
    row[j] = pivot;
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i * n + k] * b[k];
  for (std::size_t i = 0; i < n; ++i) b[i] /= a[i * n + i];
  for (std::size_t i = n; i-- > 0;)
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= a[k * n + i] * b[k];
  return true;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_SOLVE_DEFINITE_H
