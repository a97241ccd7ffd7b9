// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_MINIMUM_DEGREE_ORDER_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_MINIMUM_DEGREE_ORDER_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// An order of elimination with little fill, for a symmetric matrix with these entries off the diagonal: the row that
// comes first, and so on. Approximate minimum degree.
inline std::vector<Compressed_rows::Index> minimum_degree_order(const Compressed_rows& neighbours)
{
  const std::size_t n = neighbours.size();
  Eigen::SparseMatrix<char, Eigen::ColMajor, int> pattern{Eigen::Index(n), Eigen::Index(n)};
  std::vector<int> sizes(n);
  for (std::size_t i = 0; i < n; ++i) sizes[i] = int(neighbours[i].size()) + 1;
  pattern.reserve(sizes);
  for (std::size_t i = 0; i < n; ++i) {
    pattern.insert(int(i), int(i)) = 1;
    for (Compressed_rows::Index j : neighbours[i]) pattern.insert(int(j), int(i)) = 1;
  }
  pattern.makeCompressed();
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern, order);
  return std::vector<Compressed_rows::Index>(order.indices().data(), order.indices().data() + n);
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_MINIMUM_DEGREE_ORDER_H
