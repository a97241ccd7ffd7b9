// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_ASSEMBLY_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_ASSEMBLY_H

#include <CGAL/Animated_mesh_features/Animation/internal/Face_frames.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Frame_sweep.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_plan.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Weighted_graph.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/run_in_chunks.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
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
// M. Alexa, As-rigid-as-possible surface modeling, SGP 2007), accelerated by momentum, from zero again whenever E grows
// (B. O'Donoghue, E. Candes, Adaptive restart for accelerated gradient schemes, Found. Comput. Math. 15, 2015).
//
// The result is the same, bit for bit, whatever the number of threads.
template <class ConcurrencyTag>
class Surface_assembly
{
  typedef Surface_plan::Index Index;
  typedef Short_loop<ConcurrencyTag> Loop;
  struct State
  {
    std::vector<Eigen::Matrix3d> frames;
    std::vector<Eigen::Vector3d> points;
  };

public:
  // Starts with the frames of `points`, whose triangles have the given normals, in the order of the plan. `is_divided`:
  // whether several threads work on it.
  Surface_assembly(const Surface_plan& plan, const std::vector<Eigen::Vector3d>& points,
                   const std::vector<Eigen::Vector3d>& normals, bool is_divided)
    : m_plan(plan)
    , m_loop{is_divided}
  {
    m_state.points = points;
    m_state.frames.resize(plan.triangles.size());
    for (std::size_t t = 0; t < normals.size(); ++t)
      m_state.frames[t] = face_frame(plan.triangles[t], points, normals[t]);
    m_pulls.resize(plan.triangles.size());
  }

  // First: each of these once, which do not depend on one another. Throw Numerical_error if a factorisation fails.
  static constexpr std::size_t number_of_preparations = 2;
  void prepare(std::size_t i)
  {
    if (i == 0)
      m_face_frames = std::make_unique<Face_frames<Loop>>(m_plan, m_state.points, m_loop);
    else
      prepare_positions();
  }

  // Then.
  void begin()
  {
    m_face_frames->fit(m_state.frames);
    m_face_frames.reset();
    fit_positions();
    m_error = error();
    m_now = m_before = m_state;
  }

  // Then, as long as it returns whether to go on.
  //
  // The sqrt(E / sum of squared edges) that is left is what averages differ by from any surface: a per cent of the
  // lengths, say. Rounds end when two in succession have lowered E by less than a part in 400: what is left to gain is
  // then some per cent of E, far less than that difference.
  bool round()
  {
    const double least_gain = 2.5e-3, rounding = 1e-20; // 1e-10 of lengths
    const std::size_t most_rounds = 300, idle_rounds = 2;
    if (!(m_error > rounding * m_plan.squared_length) || m_rounds == most_rounds) return false;
    ++m_rounds;
    const double next_speed = (1 + std::sqrt(1 + 4 * m_speed * m_speed)) / 2;
    const double momentum = (m_speed - 1) / next_speed;
    if (momentum > 0) extrapolate(momentum);
    fit_frames();
    fit_positions();
    const double next_error = error();
    if (!(next_error < m_error)) {
      m_state = m_now;
      m_speed = 1;
      return momentum > 0;
    }
    m_idle_rounds = next_error > (1 - least_gain) * m_error ? m_idle_rounds + 1 : 0;
    m_error = next_error;
    m_speed = next_speed;
    std::swap(m_before, m_now);
    m_now = m_state;
    return m_idle_rounds < idle_rounds;
  }

  // in no particular place
  const std::vector<Eigen::Vector3d>& points() const { return m_state.points; }

  // E as it is, and in how many rounds
  double error_left() const { return m_error; }
  std::size_t rounds() const { return m_rounds; }

private:
  // The matrix of the positions, with uniform weights but for slivers: cotangents would be unbounded there.
  void prepare_positions()
  {
    std::vector<std::array<Index, 2>> ends;
    std::vector<double> weights;
    ends.reserve(3 * m_plan.triangles.size());
    weights.reserve(3 * m_plan.triangles.size());
    for (const Surface_plan::Triangle& t : m_plan.triangles)
      for (unsigned k = 0; k < 3; ++k) {
        ends.push_back({{t.vertices[k], t.vertices[(k + 1) % 3]}});
        weights.push_back(t.weight);
      }
    // ties one vertex to the origin, at no cost, as the whole may be anywhere
    const auto tie = [](std::size_t i, double) { return i == 0 ? 1. : 0.; };
    m_graph = std::make_unique<Weighted_graph>(ends, weights, tie, m_state.points);
    m_sides = std::make_unique<Right_hand_sides<double>>(m_graph->symbolic(), 3);
  }

  // The positions that fit the frames best.
  void fit_positions()
  {
    const auto rows = m_sides->rows();
    each(m_plan.number_of_vertices, [&](std::size_t v) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (Index corner : m_plan.corners[v]) {
        const Surface_plan::Triangle& t = m_plan.triangles[corner / 3];
        const unsigned k = corner % 3;
        sum += m_state.frames[corner / 3].template leftCols<2>() * (t.weight * (t.edges[(k + 2) % 3] - t.edges[k]));
      }
      for (int k = 0; k < 3; ++k) rows[v][std::size_t(k)] = sum[k];
    });
    m_graph->solve(*m_sides);
    each(m_plan.number_of_vertices,
         [&](std::size_t v) { m_state.points[v] = Eigen::Vector3d(rows[v][0], rows[v][1], rows[v][2]); });
  }

  // Twice each frame, with its neighbours as they are by then, hence E cannot grow: the positions take as long.
  void fit_frames()
  {
    const int sweeps = 1;
    each(m_pulls.size(), [&](std::size_t t) { m_pulls[t] = frame_pull(m_plan.triangles[t], m_state.points); });
    const Instruction_set instructions = widest_instruction_set();
    for (int i = 0; i < sweeps; ++i)
      for (std::size_t c = 0; c + 1 < m_plan.colours.size(); ++c) {
        const std::size_t begin = m_plan.colours[c], n = m_plan.colours[c + 1] - begin;
        run_in_chunks(n, m_loop, [&](std::size_t first, std::size_t last) {
          Frame_sweep sweep{m_plan, m_pulls, m_state.frames, begin + first, begin + last};
          run_reproducibly<double>(instructions, sweep);
        });
      }
  }

  // E; throws Numerical_error if it is not finite.
  double error() const
  {
    const State& s = m_state;
    double e = sum_in_chunks(m_plan.joints.size(), m_loop, [&](std::size_t first, std::size_t last) {
      double sum = 0;
      for (std::size_t i = first; i < last; ++i) {
        const Surface_plan::Joint& j = m_plan.joints[i];
        sum += j.weight * (s.frames[j.right] - s.frames[j.left] * j.transition).squaredNorm();
      }
      return sum;
    });
    e += sum_in_chunks(m_plan.triangles.size(), m_loop, [&](std::size_t first, std::size_t last) {
      double sum = 0;
      for (std::size_t i = first; i < last; ++i) {
        const Surface_plan::Triangle& t = m_plan.triangles[i];
        for (unsigned k = 0; k < 3; ++k) {
          const Eigen::Vector3d side = s.points[t.vertices[(k + 1) % 3]] - s.points[t.vertices[k]];
          sum += t.weight * (side - s.frames[i].template leftCols<2>() * t.edges[k]).squaredNorm();
        }
      }
      return sum;
    });
    if (!std::isfinite(e)) throw Numerical_error("the canonical shape: the positions are not finite");
    return e;
  }

  // The frames are no rotations then, until they are fitted.
  void extrapolate(double momentum)
  {
    each(m_now.points.size(), [&](std::size_t i) {
      m_state.points[i] = m_now.points[i] + momentum * (m_now.points[i] - m_before.points[i]);
    });
    each(m_now.frames.size(), [&](std::size_t t) {
      m_state.frames[t] = m_now.frames[t] + momentum * (m_now.frames[t] - m_before.frames[t]);
    });
  }

  template <class Task>
  void each(std::size_t n, const Task& task) const
  {
    run_in_chunks(n, m_loop, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) task(i);
    });
  }

  const Surface_plan& m_plan;
  Loop m_loop;
  State m_state, m_now, m_before; // as tried; the best one; the one before it
  std::vector<Frame_pull> m_pulls;
  std::unique_ptr<Face_frames<Loop>> m_face_frames;
  std::unique_ptr<Weighted_graph> m_graph; // of the vertices
  std::unique_ptr<Right_hand_sides<double>> m_sides;
  double m_error = 0, m_speed = 1;
  std::size_t m_rounds = 0, m_idle_rounds = 0;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_SURFACE_ASSEMBLY_H
