// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_FRAME_SWEEP_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_FRAME_SWEEP_H

#include <CGAL/Animated_mesh_features/Animation/internal/Surface_plan.h>
#include <CGAL/Animated_mesh_features/Animation/internal/nearest_rotation.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// What the sides of a triangle as they lie ask of its frame: sum of w (p_j - p_i) x_ij^T, two columns.
typedef Eigen::Matrix<double, 3, 2> Frame_pull;

inline Frame_pull frame_pull(const Surface_plan::Triangle& t, const std::vector<Eigen::Vector3d>& points)
{
  Frame_pull pull = Frame_pull::Zero();
  for (unsigned k = 0; k < 3; ++k)
    pull += (points[t.vertices[(k + 1) % 3]] - points[t.vertices[k]]) * (t.weight * t.edges[k]).transpose();
  return pull;
}

// Fits the frames of some triangles of one colour, each to its own sides and to the frames of its neighbours, which are
// of other colours: the rotation nearest to the sum of what they ask for.
struct Frame_sweep
{
  const Surface_plan& plan;
  const std::vector<Frame_pull>& pulls;
  std::vector<Eigen::Matrix3d>& frames;
  std::size_t first, last;

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    for (std::size_t t = first; t < last; t += matrices_at_once) {
      const std::size_t n = (std::min)(matrices_at_once, last - t);
      Matrix_group group;
      for (std::size_t i = 0; i < matrices_at_once; ++i) gather(t + (std::min)(i, n - 1), i, group);
      nearest_rotations<Pack<double, matrices_at_once, register_bytes>>(group);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < 9; ++k) frames[t + i].data()[k] = group[k][i];
    }
  }

private:
  // Products by hand, as Eigen's are compiled for other registers than those of the loop.
  CGAL_ANIMATED_MESH_FEATURES_INLINE void gather(std::size_t t, std::size_t i, Matrix_group& group) const
  {
    const Surface_plan::Triangle& triangle = plan.triangles[t];
    const double* const pull = pulls[t].data();
    double m[9] = {pull[0], pull[1], pull[2], pull[3], pull[4], pull[5], 0, 0, 0};
    for (Surface_plan::Index j : triangle.joints) {
      if (j == Surface_plan::no_joint) continue;
      const Surface_plan::Joint& joint = plan.joints[j];
      if (joint.left == t)
        add<3, 1>(frames[joint.right].data(), joint, m); // w R_right T^T
      else
        add<1, 3>(frames[joint.left].data(), joint, m); // w R_left T
    }
    for (std::size_t k = 0; k < 9; ++k) group[k][i] = m[k];
  }

  template <std::size_t row, std::size_t column>
  static CGAL_ANIMATED_MESH_FEATURES_INLINE void add(const double* r, const Surface_plan::Joint& joint, double (&m)[9])
  {
    const double* const transition = joint.transition.data();
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (std::size_t c = 0; c < 3; ++c) {
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t k = 0; k < 3; ++k) {
        const double factor = joint.weight * transition[k * row + c * column];
        CGAL_ANIMATED_MESH_FEATURES_UNROLL
        for (std::size_t l = 0; l < 3; ++l) m[3 * c + l] += r[3 * k + l] * factor;
      }
    }
  }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_FRAME_SWEEP_H
