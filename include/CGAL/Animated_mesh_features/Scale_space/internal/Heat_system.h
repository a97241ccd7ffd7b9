// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_HEAT_SYSTEM_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_HEAT_SYSTEM_H

#include <CGAL/Animated_mesh_features/Animation/Animation_report.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/Sparse_cholesky.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The lumped masses M and the cotangent Laplacian L of a shape, in units of the mean mass, so that M + t L does not
// depend on the unit of length. A vertex that is in no proper triangle has mass 1 and no neighbours that matter.
class Heat_system
{
public:
  explicit Heat_system(const Rest_shape& shape)
    : m_symbolic(shape.neighbours(), shape.points())
    , m_mass(shape.number_of_vertices(), 0)
    , m_weights(neighbours().number_of_entries(), 0)
    , m_diagonal(shape.number_of_vertices(), 0)
  {
    for (Rest_shape::Index t : shape.ordered_triangles()) {
      if (is_degenerate(shape, t)) continue;
      const Rest_shape::Triangle& corner = shape.triangles()[t];
      for (int i = 0; i < 3; ++i) {
        const Rest_shape::Index a = corner[(i + 1) % 3], b = corner[(i + 2) % 3];
        const Rest_shape::Point& p = shape.points()[corner[i]];
        m_mass[corner[i]] += shape.areas()[t] / 3;
        // half the cotangent of the angle at p: (u . w) / |u x w| / 2 with |u x w| = 2 area
        const double c = (shape.points()[a] - p).dot(shape.points()[b] - p) / (4 * shape.areas()[t]);
        m_weights[entry(a, b)] += c;
        m_weights[entry(b, a)] += c;
        m_diagonal[a] += c;
        m_diagonal[b] += c;
      }
    }
    double total = 0;
    for (double m : m_mass) total += m;
    m_mean_mass = total / double(m_mass.size());
    m_is_on_surface.reserve(m_mass.size());
    for (double& m : m_mass) {
      m_is_on_surface.push_back(m > 0);
      m = m > 0 ? m / m_mean_mass : 1;
    }
    for (double& w : m_weights) w /= m_mean_mass;
    for (double& d : m_diagonal) d /= m_mean_mass;
  }

  std::size_t size() const { return m_mass.size(); }
  const Symbolic_cholesky& symbolic() const { return m_symbolic; }
  const std::vector<double>& mass() const { return m_mass; }
  const Compressed_rows& neighbours() const { return m_symbolic.neighbours(); }

  // The unit of all masses, an area; zero if there is no proper triangle.
  double mean_mass() const { return m_mean_mass; }

  // Whether v is in a proper triangle.
  bool is_on_surface(std::size_t v) const { return m_is_on_surface[v] != 0; }

  // -L, for each of the neighbours of v.
  const double* weights(std::size_t v) const { return m_weights.data() + first_entry(v); }

  // of M + t L
  template <class T>
  Sparse_cholesky<T> factor(double t, Instruction_set instructions) const
  {
    return Sparse_cholesky<T>(
        m_symbolic, [&](std::size_t v) { return m_mass[v] + t * m_diagonal[v]; },
        [&](std::size_t v, std::size_t k) { return -t * m_weights[first_entry(v) + k]; }, instructions);
  }

private:
  std::size_t first_entry(std::size_t v) const
  {
    return std::size_t(neighbours()[v].begin() - neighbours()[0].begin());
  }

  std::size_t entry(Rest_shape::Index v, Rest_shape::Index w) const
  {
    const Compressed_rows::Row row = neighbours()[v];
    return first_entry(v) + std::size_t(std::lower_bound(row.begin(), row.end(), w) - row.begin());
  }

  Symbolic_cholesky m_symbolic; // with a copy of the neighbours, as filters live on when shapes are gone
  std::vector<double> m_mass, m_weights, m_diagonal;
  std::vector<char> m_is_on_surface;
  double m_mean_mass = 0;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_HEAT_SYSTEM_H
