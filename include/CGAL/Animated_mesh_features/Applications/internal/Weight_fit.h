// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_WEIGHT_FIT_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_WEIGHT_FIT_H

#include <CGAL/Animated_mesh_features/Applications/internal/Followed_vertices.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_positions.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_quadrics.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Quadric.h>
#include <CGAL/Animated_mesh_features/Applications/internal/solve_definite.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Finds the weights with which a vertex follows others so that the quadrics of an edge, summed over poses, are least.
class Weight_fit
{
public:
  // Changes the weights, whose sum stays 1, in the sense of least squares: each step u_k from the heaviest vertex to
  // another one costs a little, and so does each step of the place, so that what does not matter stays. `i`, `j`: the
  // ends of the edge; `original`: the positions of what is followed. The heaviest comes first.
  void improve(const Pose_quadrics& quadrics, std::size_t i, std::size_t j, const Pose_positions& original,
               Followed_vertices& followed)
  {
    const std::size_t n = followed.size() - 1;
    if (n == 0) return;
    followed.bring_heaviest_first();
    m_matrix.assign(n * n, 0.);
    m_right.assign(n, 0.);
    m_steps.resize(6 * n);
    for (std::size_t p = 0; p < quadrics.number_of_poses(); ++p) add_pose(quadrics.sum(i, j, p), p, original, followed);
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += m_matrix[k * n + k];
    const double ridge = weight_ridge * sum / double(n);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l <= k; ++l) m_matrix[k * n + l] += k == l ? 2 * ridge : ridge;
    if (!solve_definite(m_matrix, m_right, n)) return;
    for (std::size_t k = 0; k < n; ++k) {
      followed.weights[k + 1] += m_right[k];
      followed.weights[0] -= m_right[k];
    }
  }

private:
  static constexpr double weight_ridge = 1e-4; // of the mean diagonal

  // to the normal equations
  void add_pose(Quadric a, std::size_t p, const Pose_positions& original, const Followed_vertices& followed)
  {
    const std::size_t n = followed.size() - 1;
    const std::array<double, 3> reference = original.point(followed.vertices[0], p);
    std::array<double, 3> x = reference;
    for (std::size_t k = 0; k < n; ++k) {
      const std::array<double, 3> y = original.point(followed.vertices[k + 1], p);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        m_steps[6 * k + axis] = y[axis] - reference[axis];
        x[axis] += followed.weights[k + 1] * (y[axis] - reference[axis]);
      }
    }
    const std::array<double, 3> g = half_gradient(a, x);
    const double small = Pose_quadrics::regularisation * trace(a);
    a[0] += small;
    a[3] += small;
    a[5] += small;
    for (std::size_t k = 0; k < n; ++k) {
      double* const e = m_steps.data() + 6 * k;
      const std::array<double, 3> ae = product(a, {{e[0], e[1], e[2]}});
      std::copy(ae.begin(), ae.end(), e + 3);
      m_right[k] -= e[0] * g[0] + e[1] * g[1] + e[2] * g[2];
      for (std::size_t l = 0; l <= k; ++l) {
        const double* const f = m_steps.data() + 6 * l;
        m_matrix[k * n + l] += ae[0] * f[0] + ae[1] * f[1] + ae[2] * f[2];
      }
    }
  }

  std::vector<double> m_matrix, m_right, m_steps; // of one edge
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_WEIGHT_FIT_H
