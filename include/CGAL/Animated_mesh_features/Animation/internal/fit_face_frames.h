// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_FIT_FACE_FRAMES_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_FIT_FACE_FRAMES_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_plan.h>
#include <CGAL/Animated_mesh_features/Animation/internal/nearest_rotation.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <array>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The frame of a triangle that lies at `points` and has that normal.
inline Eigen::Matrix3d face_frame(const Surface_plan::Triangle& triangle, const std::vector<Eigen::Vector3d>& points,
                                  const Eigen::Vector3d& normal)
{
  const std::array<std::size_t, 3>& v = triangle.vertices;
  Eigen::Vector3d x = points[v[(triangle.base + 1) % 3]] - points[v[triangle.base]];
  x -= normal * normal.dot(x);
  if (!(x.norm() > 0)) x = normal.unitOrthogonal();
  x.normalize();
  Eigen::Matrix3d frame;
  frame << x, normal.cross(x), normal;
  return frame;
}

// Turns `frames` so that they minimise, all at once,
//   sum over joints w |R_right - R_left T|^2,
// the first of the two linear systems of Y. Wang, B. Liu, Y. Tong, Linear surface reconstruction from discrete
// fundamental forms on triangle meshes, Computer Graphics Forum 31(8), 2012. It is linear as long as the R may be any
// matrices, and determines them up to one rotation of the whole. Instead of holding one triangle, from which the size
// of the matrices would fade wherever the angles disagree, a few steps of inverse iteration with a small shift look
// for the smallest eigenspace, with the frames made rotations in between; A. Singer, Angular synchronization by
// eigenvectors and semidefinite programming, Appl. Comput. Harmon. Anal. 30(1), 2011. The shift also keeps parts that
// no joint connects.
//
// Complexity: a sparse factorisation of size 3 T, for T triangles O(T log T) entries.
// Throws Numerical_error if it fails.
inline void fit_face_frames(const Surface_plan& plan, std::vector<Eigen::Matrix3d>& frames)
{
  // Small against what bends a whole mesh, large against rounding; anything between 1e-6 and 1e-10 gives the same.
  const double relative_shift = 1e-8;
  const int iterations = 5; // the rounds that follow bring the rest

  typedef Eigen::SparseMatrix<double> Matrix;
  const std::size_t n = frames.size();
  std::vector<double> diagonal(n, 0.);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(18 * plan.joints.size() + 3 * n);
  double sum = 0;
  for (const Surface_plan::Joint& j : plan.joints) {
    diagonal[j.left] += j.weight;
    diagonal[j.right] += j.weight;
    sum += 2 * j.weight;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        const int left = 3 * int(j.left) + r, right = 3 * int(j.right) + c;
        entries.emplace_back(left, right, -j.weight * j.transition(r, c));
        entries.emplace_back(right, left, -j.weight * j.transition(r, c));
      }
  }
  if (sum == 0) return;
  std::vector<double> shifts(n);
  for (std::size_t t = 0; t < n; ++t) {
    shifts[t] = relative_shift * (diagonal[t] > 0 ? diagonal[t] : sum / double(n));
    for (int r = 0; r < 3; ++r) entries.emplace_back(3 * int(t) + r, 3 * int(t) + r, diagonal[t] + shifts[t]);
  }
  Matrix matrix(3 * int(n), 3 * int(n));
  matrix.setFromTriplets(entries.begin(), entries.end());
  std::vector<Eigen::Triplet<double>>().swap(entries); // as large as the factor of a small mesh
  const Eigen::SimplicialLDLT<Matrix> solver(matrix);
  if (solver.info() != Eigen::Success)
    throw Numerical_error("the canonical shape: the factorisation for the face frames failed");

  // The transposed frames one below the other, as the transitions act on the right.
  Eigen::Matrix<double, Eigen::Dynamic, 3> y(3 * Eigen::Index(n), 3);
  for (int i = 0; i < iterations; ++i) {
    cancellation_point();
    for (std::size_t t = 0; t < n; ++t) y.middleRows<3>(3 * Eigen::Index(t)) = shifts[t] * frames[t].transpose();
    y = solver.solve(y);
    if (!y.allFinite()) throw Numerical_error("the canonical shape: the face frames are not finite");
    for (std::size_t t = 0; t < n; ++t)
      frames[t] = nearest_rotation(Eigen::Matrix3d(y.middleRows<3>(3 * Eigen::Index(t)).transpose()));
  }
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_FIT_FACE_FRAMES_H
