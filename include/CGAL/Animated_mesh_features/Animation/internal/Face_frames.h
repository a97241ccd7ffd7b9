// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_FACE_FRAMES_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_FACE_FRAMES_H

#include <CGAL/Animated_mesh_features/Animation/internal/Surface_plan.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Weighted_graph.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/run_in_chunks.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The frame of a triangle that lies at `points` and has that normal.
inline Eigen::Matrix3d face_frame(const Surface_plan::Triangle& triangle, const std::vector<Eigen::Vector3d>& points,
                                  const Eigen::Vector3d& normal)
{
  const auto& v = triangle.vertices;
  Eigen::Vector3d x = points[v[(triangle.base + 1) % 3]] - points[v[triangle.base]];
  x -= normal * normal.dot(x);
  if (!(x.norm() > 0)) x = normal.unitOrthogonal();
  x.normalize();
  Eigen::Matrix3d frame;
  frame << x, normal.cross(x), normal;
  return frame;
}

// The vector along the axis of a rotation, as long as its angle in radians. Of half a turn, which may be about either
// direction, none.
inline Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& r)
{
  const Eigen::Vector3d v(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  const double sine = v.norm() / 2, cosine = (r.trace() - 1) / 2;
  return sine > 0 ? Eigen::Vector3d(v * (std::atan2(sine, cosine) / (2 * sine))) : Eigen::Vector3d(v / 2);
}

// Its inverse; O. Rodrigues' formula.
inline Eigen::Matrix3d rotation_about(const Eigen::Vector3d& v)
{
  const double angle = v.norm();
  return angle > 0 ? Eigen::AngleAxisd(angle, v / angle).toRotationMatrix() : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

// A loop over chunks of what takes a moment, which tells nobody how far it is; by one thread, if there is too little to be
// divided.
template <class ConcurrencyTag>
struct Short_loop
{
  bool is_divided = true;

  template <class Task>
  void operator()(std::size_t n, const Task& task) const
  {
    cancellation_point();
    if (is_divided)
      parallel_for<ConcurrencyTag>(0, n, task);
    else
      for (std::size_t i = 0; i < n; ++i) task(i);
  }
};

// The sum of task(first, last) over chunks, in their order.
template <class Loop, class Task>
double sum_in_chunks(std::size_t n, const Loop& loop, const Task& task)
{
  constexpr std::size_t chunk = 1024;
  std::vector<double> sums((n + chunk - 1) / chunk);
  loop(sums.size(), [&](std::size_t i) { sums[i] = task(i * chunk, (std::min)(n, (i + 1) * chunk)); });
  double sum = 0;
  for (double s : sums) sum += s;
  return sum;
}

// Turns frames so that neighbours fit as well as they can: minimises the sum over joints of
//   w angle(R_right, R_left T)^2.
// A vector that is a rotation's axis, as long as its angle, for each triangle: to first order, the frames turn by
// vectors whose differences across joints are those by which the joints do not fit. These are the normal equations of
// a Laplacian on the graph of triangles, the same in each of a few Gauss-Newton steps; V. M. Govindu, Lie-algebraic
// averaging for globally consistent motion estimation, CVPR 2004. Errors along long limbs, which iterations from
// triangle to triangle would need as many rounds for as there are triangles along it, are gone after two or three.
template <class Loop>
class Face_frames
{
public:
  Face_frames(const Surface_plan& plan, const std::vector<Eigen::Vector3d>& points, const Loop& loop)
    : m_plan(plan)
    , m_loop(loop)
    , m_graph(joint_ends(plan), joint_weights(plan), shift(plan), centers(plan, points))
    , m_turns(m_graph.symbolic(), 3)
    , m_errors(plan.joints.size())
  {}

  // Throws Numerical_error if the turns are not finite.
  void fit(std::vector<Eigen::Matrix3d>& frames)
  {
    const int most_steps = 10, most_halvings = 5;
    const double least_gain = 0.1; // the rounds that follow bring the rest
    double error = measure(frames);
    std::vector<Eigen::Matrix3d> turned(frames.size());
    for (int step = 0; step < most_steps && error > 0; ++step) {
      find_turns();
      double next_error = error, share = 1;
      for (int i = 0; i < most_halvings && !(next_error < error); ++i, share /= 2) {
        turn(frames, share, turned);
        next_error = measure(turned);
      }
      if (!(next_error < error)) return;
      frames.swap(turned);
      if (next_error > (1 - least_gain) * error) return;
      error = next_error;
    }
  }

private:
  typedef Surface_plan::Index Index;

  static std::vector<std::array<Index, 2>> joint_ends(const Surface_plan& plan)
  {
    std::vector<std::array<Index, 2>> ends;
    ends.reserve(plan.joints.size());
    for (const Surface_plan::Joint& j : plan.joints) ends.push_back({{j.left, j.right}});
    return ends;
  }

  static std::vector<double> joint_weights(const Surface_plan& plan)
  {
    std::vector<double> weights;
    weights.reserve(plan.joints.size());
    for (const Surface_plan::Joint& j : plan.joints) weights.push_back(j.weight);
    return weights;
  }

  // All frames may turn together, hence a small shift; it also keeps parts that no joint connects. Large against
  // rounding, small against what bends a whole mesh: by how much it slows down a turn is made up for by the next step.
  static auto shift(const Surface_plan& plan)
  {
    const double relative_shift = 1e-10;
    double sum = 0;
    for (const Surface_plan::Joint& j : plan.joints) sum += 2 * j.weight;
    const double usual = sum > 0 ? sum / double(plan.triangles.size()) : 1;
    return [=](std::size_t, double weights) { return weights > 0 ? relative_shift * weights : usual; };
  }

  static std::vector<Eigen::Vector3d> centers(const Surface_plan& plan, const std::vector<Eigen::Vector3d>& points)
  {
    std::vector<Eigen::Vector3d> result;
    result.reserve(plan.triangles.size());
    for (const Surface_plan::Triangle& t : plan.triangles)
      result.push_back((points[t.vertices[0]] + points[t.vertices[1]] + points[t.vertices[2]]) / 3);
    return result;
  }

  // By which turn each joint does not fit, times its weight; returns the sum that is minimised.
  double measure(const std::vector<Eigen::Matrix3d>& frames)
  {
    return sum_in_chunks(m_plan.joints.size(), m_loop, [&](std::size_t first, std::size_t last) {
      double sum = 0;
      for (std::size_t i = first; i < last; ++i) {
        const Surface_plan::Joint& j = m_plan.joints[i];
        const Eigen::Matrix3d turn = frames[j.left] * j.transition * frames[j.right].transpose();
        const Eigen::Vector3d v = rotation_vector(turn);
        sum += j.weight * v.squaredNorm();
        m_errors[i] = j.weight * v;
      }
      return sum;
    });
  }

  void find_turns()
  {
    const auto rows = m_turns.rows();
    run_in_chunks(m_plan.triangles.size(), m_loop, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (Index i : m_plan.triangles[t].joints) {
          if (i == Surface_plan::no_joint) continue;
          if (m_plan.joints[i].right == t)
            sum += m_errors[i];
          else
            sum -= m_errors[i];
        }
        for (int k = 0; k < 3; ++k) rows[t][std::size_t(k)] = sum[k];
      }
    });
    m_graph.solve(m_turns);
  }

  void turn(const std::vector<Eigen::Matrix3d>& frames, double share, std::vector<Eigen::Matrix3d>& turned) const
  {
    const auto rows = m_turns.rows();
    const double not_finite = sum_in_chunks(frames.size(), m_loop, [&](std::size_t first, std::size_t last) {
      double count = 0;
      for (std::size_t t = first; t < last; ++t) {
        const Eigen::Vector3d v(rows[t][0], rows[t][1], rows[t][2]);
        if (!v.allFinite()) count += 1;
        turned[t] = rotation_about(share * v) * frames[t];
      }
      return count;
    });
    if (not_finite > 0) throw Numerical_error("the canonical shape: the face frames are not finite");
  }

  const Surface_plan& m_plan;
  Loop m_loop;
  Weighted_graph m_graph;
  Right_hand_sides<double> m_turns;
  std::vector<Eigen::Vector3d> m_errors; // of joints
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_FACE_FRAMES_H
