// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_ASSEMBLY_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_ASSEMBLY_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_plan.h>
#include <CGAL/Animated_mesh_features/Animation/internal/fit_face_frames.h>
#include <CGAL/Animated_mesh_features/Animation/internal/nearest_rotation.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Assembles one component after its plan: frames R_t, which are rotations, and positions p that minimise
//   E(R, p) = sum over joints    w |R_right - R_left T|^2
//           + sum over triangles w sum over edges |p_j - p_i - R_t x_ij|^2.
// Both terms are an area times the square of a number without unit: an angle that is wrong by 0.01 weighs about as much
// as a length that is wrong by one per cent, whatever the size of the body and of its triangles. The plan of a surface
// gives E = 0 there; a plan of averages gives a surface as close to it as there is.
//
// Frames first, then rounds in which E is minimised over each frame in turn and over all positions at once (O. Sorkine,
// M. Alexa, As-rigid-as-possible surface modeling, SGP 2007). Alone, the rounds straighten long limbs slowly; they are
// accelerated by momentum, from zero again whenever E grows (B. O'Donoghue, E. Candes, Adaptive restart for accelerated
// gradient schemes, Found. Comput. Math. 15, 2015), which saves more than nine rounds of ten.
class Surface_assembly
{
  typedef Eigen::SparseMatrix<double> Matrix;
  struct State
  {
    std::vector<Eigen::Matrix3d> frames;
    std::vector<Eigen::Vector3d> points;
  };

public:
  // The frames start as those of `points`, whose triangles have the given normals.
  // Throws Numerical_error if a factorisation fails.
  Surface_assembly(const Surface_plan& plan, const std::vector<Eigen::Vector3d>& points,
                   const std::vector<Eigen::Vector3d>& normals)
    : m_plan(plan)
  {
    m_state.points = points;
    m_state.frames.resize(plan.triangles.size());
    for (std::size_t t = 0; t < normals.size(); ++t)
      m_state.frames[t] = face_frame(plan.triangles[t], points, normals[t]);
    factor_laplacian();
    fit_face_frames(plan, m_state.frames);
    fit_positions();
    refine();
  }

  // in no particular place
  const std::vector<Eigen::Vector3d>& points() const { return m_state.points; }

  // how many rounds there were
  std::size_t rounds() const { return m_rounds; }

private:
  // The matrix of the positions, with uniform weights but for slivers: cotangents would be unbounded there.
  void factor_laplacian()
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(12 * m_plan.triangles.size() + 1);
    for (const Surface_plan::Triangle& t : m_plan.triangles)
      for (unsigned k = 0; k < 3; ++k) {
        const int i = int(t.vertices[k]), j = int(t.vertices[(k + 1) % 3]);
        entries.emplace_back(i, i, t.weight);
        entries.emplace_back(j, j, t.weight);
        entries.emplace_back(i, j, -t.weight);
        entries.emplace_back(j, i, -t.weight);
      }
    entries.emplace_back(0, 0, 1.); // ties one vertex to the origin, at no cost, as the whole may be anywhere
    Matrix laplacian(int(m_plan.number_of_vertices), int(m_plan.number_of_vertices));
    laplacian.setFromTriplets(entries.begin(), entries.end());
    m_solver.compute(laplacian);
    if (m_solver.info() != Eigen::Success)
      throw Numerical_error("the canonical shape: the factorisation for the positions failed");
  }

  void fit_positions()
  {
    typedef Eigen::Matrix<double, Eigen::Dynamic, 3> Columns;
    Columns b = Columns::Zero(Eigen::Index(m_plan.number_of_vertices), 3);
    for (std::size_t t = 0; t < m_plan.triangles.size(); ++t) {
      const Surface_plan::Triangle& triangle = m_plan.triangles[t];
      for (unsigned k = 0; k < 3; ++k) {
        const Eigen::Vector3d d = triangle.weight * (m_state.frames[t].leftCols<2>() * triangle.edges[k]);
        b.row(Eigen::Index(triangle.vertices[k])) -= d.transpose();
        b.row(Eigen::Index(triangle.vertices[(k + 1) % 3])) += d.transpose();
      }
    }
    b = m_solver.solve(b);
    if (!b.allFinite()) throw Numerical_error("the canonical shape: the positions are not finite");
    for (std::size_t i = 0; i < m_state.points.size(); ++i) m_state.points[i] = b.row(Eigen::Index(i)).transpose();
  }

  Eigen::Vector3d side(std::size_t t, unsigned k) const
  {
    const std::array<std::size_t, 3>& v = m_plan.triangles[t].vertices;
    return m_state.points[v[(k + 1) % 3]] - m_state.points[v[k]];
  }

  // Each frame with its neighbours as they are by then, hence E cannot grow.
  void fit_each_frame()
  {
    std::vector<Eigen::Matrix3d>& frames = m_state.frames;
    for (std::size_t t = 0; t < frames.size(); ++t) {
      const Surface_plan::Triangle& triangle = m_plan.triangles[t];
      Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
      for (unsigned k = 0; k < 3; ++k) {
        m.leftCols<2>() += triangle.weight * side(t, k) * triangle.edges[k].transpose();
        if (triangle.joints[k] == Surface_plan::no_joint) continue;
        const Surface_plan::Joint& joint = m_plan.joints[triangle.joints[k]];
        if (joint.left == t)
          m += joint.weight * frames[joint.right] * joint.transition.transpose();
        else
          m += joint.weight * frames[joint.left] * joint.transition;
      }
      frames[t] = nearest_rotation(m);
    }
  }

  double energy() const
  {
    double e = 0;
    for (const Surface_plan::Joint& j : m_plan.joints)
      e += j.weight * (m_state.frames[j.right] - m_state.frames[j.left] * j.transition).squaredNorm();
    for (std::size_t t = 0; t < m_plan.triangles.size(); ++t) {
      const Surface_plan::Triangle& triangle = m_plan.triangles[t];
      for (unsigned k = 0; k < 3; ++k)
        e += triangle.weight * (side(t, k) - m_state.frames[t].leftCols<2>() * triangle.edges[k]).squaredNorm();
    }
    return e;
  }

  void refine()
  {
    // With momentum some 50 times the last move is left to go. Fewer than 200 rounds are usual.
    const double least_move = 5e-7; // root mean square, in units of the body's size
    const std::size_t most_rounds = 500;

    State now = m_state, before = m_state;
    double e = energy(), speed = 1;
    for (m_rounds = 0; m_rounds < most_rounds; ++m_rounds) {
      cancellation_point();
      const double next_speed = (1 + std::sqrt(1 + 4 * speed * speed)) / 2;
      const double momentum = (speed - 1) / next_speed;
      if (momentum > 0) extrapolate(now, before, momentum);
      fit_each_frame();
      fit_positions();
      const double next_e = energy();
      if (!(next_e < e)) {
        m_state = now;
        if (momentum == 0) break;
        speed = 1;
        continue;
      }
      e = next_e;
      double squared_move = 0;
      for (std::size_t i = 0; i < now.points.size(); ++i)
        squared_move += (m_state.points[i] - now.points[i]).squaredNorm();
      if (squared_move < least_move * least_move * m_plan.squared_length * double(now.points.size())) break;
      speed = next_speed;
      std::swap(before, now);
      now = m_state;
    }
  }

  // The frames are no rotations then, until they are fitted.
  void extrapolate(const State& now, const State& before, double momentum)
  {
    for (std::size_t i = 0; i < now.points.size(); ++i)
      m_state.points[i] = now.points[i] + momentum * (now.points[i] - before.points[i]);
    for (std::size_t t = 0; t < now.frames.size(); ++t)
      m_state.frames[t] = now.frames[t] + momentum * (now.frames[t] - before.frames[t]);
  }

  const Surface_plan& m_plan;
  State m_state;
  Eigen::SimplicialLDLT<Matrix> m_solver;
  std::size_t m_rounds = 0;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_ASSEMBLY_H
