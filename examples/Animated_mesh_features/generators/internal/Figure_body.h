// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_INTERNAL_FIGURE_BODY_H
#define ANIMATED_MESH_GENERATORS_INTERNAL_FIGURE_BODY_H

#include "Round_cone.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace Animated_mesh_generators {
namespace internal {

/*!
The figure at rest: a small two-legged animal with the long ears of a hare and the long tail of a jerboa, standing on
the plane z = 0, looking along +x, its left towards +y, about two units high.

A tree of bones, each turning about its joint, and round cones of flesh, each belonging to a bone. The surface is where
the smooth union of the cones is zero; the share of a bone in the motion of a point is a smooth function of the point's
distance to the bone's flesh. Both depend on the place alone, not on how the surface is sampled.
*/
class Figure_body
{
public:
  struct Bone
  {
    std::string name;
    /// the rank of the bone that carries this one; the root carries itself. Parents come first.
    std::size_t parent;
    Eigen::Vector3d joint;
    /// how far (length) beyond its own flesh the bone takes part in the motion.
    double reach;
  };

  struct Flesh
  {
    std::size_t bone;
    Round_cone cone;
    /// the width over which it melts into what was added before it.
    double blend;
  };

  Figure_body()
  {
    add_trunk();
    add_tail();
    add_side("left", 1);
    add_side("right", -1);
  }

  const std::vector<Bone>& bones() const { return m_bones; }
  const std::vector<Flesh>& flesh() const { return m_flesh; }

  /// the rank of the bone of a name, which must exist.
  std::size_t bone(const std::string& name) const
  {
    std::size_t i = 0;
    while (m_bones[i].name != name) ++i;
    return i;
  }

  /// negative inside of the figure, zero on its surface, positive outside; near the surface about the distance.
  double value(const Eigen::Vector3d& p) const
  {
    double d = m_flesh.front().cone.distance(p);
    for (std::size_t i = 1; i < m_flesh.size(); ++i)
      d = smooth_minimum(d, m_flesh[i].cone.distance(p), m_flesh[i].blend);
    return d;
  }

  /// the gradient of `value()`, by central differences.
  Eigen::Vector3d gradient(const Eigen::Vector3d& p) const
  {
    // The error of a central difference, h^2 against rounding / h, is least at the cube root of the rounding.
    const double h = 1e-5;
    Eigen::Vector3d g;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
      g[i] = (value(p + step) - value(p - step)) / (2 * h);
    }
    return g;
  }

  /// the bones that move a point on the surface, and their shares, which sum to 1.
  std::vector<std::pair<std::size_t, double>> shares(const Eigen::Vector3d& p) const
  {
    std::vector<double> distance(m_bones.size(), (std::numeric_limits<double>::max)());
    for (const Flesh& f : m_flesh) distance[f.bone] = (std::min)(distance[f.bone], f.cone.distance(p));
    // Where flesh has melted together the surface is outside of all of it, but by less than any reach: someone shares.
    std::vector<std::pair<std::size_t, double>> result;
    double sum = 0;
    for (std::size_t i = 0; i < m_bones.size(); ++i) {
      const double x = (std::max)(0., distance[i]) / m_bones[i].reach;
      if (x >= 1) continue;
      const double y = 1 - x * x;
      result.emplace_back(i, y * y * y);
      sum += result.back().second;
    }
    for (auto& share : result) share.second /= sum;
    return result;
  }

private:
  typedef Eigen::Vector3d V;

  void add_bone(const std::string& name, const std::string& parent, const V& joint, double reach)
  {
    m_bones.push_back({name, parent.empty() ? 0 : bone(parent), joint, reach});
  }

  void add_flesh(const V& from, const V& to, double from_radius, double to_radius, double blend)
  {
    m_flesh.push_back({m_bones.size() - 1, {from, to, from_radius, to_radius}, blend});
  }

  // The figure is drawn by eye: its measures have no other reason.

  void add_trunk()
  {
    add_bone("pelvis", "", V(0, 0, 0.74), 0.14);
    add_flesh(V(-0.03, 0, 0.74), V(0, 0, 0.86), 0.18, 0.195, 0.1);
    add_bone("chest", "pelvis", V(0, 0, 0.88), 0.14);
    add_flesh(V(0.01, 0, 0.96), V(0.02, 0, 1.1), 0.17, 0.12, 0.1);
    add_bone("neck", "chest", V(0.02, 0, 1.15), 0.08);
    add_flesh(V(0.02, 0, 1.15), V(0.05, 0, 1.25), 0.085, 0.085, 0.06);
    add_bone("head", "neck", V(0.04, 0, 1.24), 0.09);
    add_flesh(V(0.03, 0, 1.42), V(0.1, 0, 1.39), 0.215, 0.19, 0.06);
    add_flesh(V(0.2, 0, 1.34), V(0.31, 0, 1.33), 0.12, 0.07, 0.06);
  }

  void add_tail()
  {
    const std::array<V, 7> joint = {{V(-0.1, 0, 0.7), V(-0.27, 0, 0.6), V(-0.43, 0, 0.55), V(-0.59, 0, 0.56),
                                     V(-0.74, 0, 0.63), V(-0.87, 0, 0.75), V(-0.95, 0, 0.9)}};
    const std::array<double, 7> radius = {{0.1, 0.06, 0.047, 0.042, 0.042, 0.07, 0.035}};
    for (std::size_t i = 0; i < 6; ++i) {
      add_bone("tail" + std::to_string(i), i == 0 ? "pelvis" : "tail" + std::to_string(i - 1), joint[i], 0.07);
      add_flesh(joint[i], joint[i + 1], radius[i], radius[i + 1], i == 0 ? 0.08 : 0.01);
    }
  }

  // `y` is 1 for the left side, -1 for the right one.
  void add_side(const std::string& side, double y)
  {
    const V hip(0, 0.115 * y, 0.72), knee(0.05, 0.155 * y, 0.42), ankle(-0.03, 0.165 * y, 0.1),
        ball(0.16, 0.19 * y, 0.055), toe(0.29, 0.205 * y, 0.05);
    add_bone(side + " thigh", "pelvis", hip, 0.11);
    add_flesh(hip, knee, 0.13, 0.08, 0.06);
    add_bone(side + " shin", side + " thigh", knee, 0.085);
    add_flesh(knee, ankle, 0.08, 0.048, 0.02);
    add_bone(side + " foot", side + " shin", ankle, 0.05);
    add_flesh(ankle, ball, 0.052, 0.06, 0.03);
    add_bone(side + " toes", side + " foot", ball, 0.045);
    add_flesh(ball, toe, 0.06, 0.05, 0.02);

    const V shoulder(0.02, 0.13 * y, 1.09), elbow(0.01, 0.33 * y, 0.97), wrist(0.05, 0.5 * y, 0.84),
        finger(0.09, 0.58 * y, 0.77);
    add_bone(side + " arm", "chest", shoulder, 0.11);
    add_flesh(shoulder, elbow, 0.062, 0.05, 0.06);
    add_bone(side + " forearm", side + " arm", elbow, 0.065);
    add_flesh(elbow, wrist, 0.05, 0.04, 0.02);
    add_bone(side + " hand", side + " forearm", wrist, 0.04);
    add_flesh(wrist, finger, 0.045, 0.06, 0.02);

    const std::array<V, 4> ear = {
        {V(0.02, 0.1 * y, 1.58), V(-0.01, 0.15 * y, 1.75), V(-0.05, 0.2 * y, 1.92), V(-0.1, 0.24 * y, 2.07)}};
    const std::array<double, 4> radius = {{0.05, 0.07, 0.07, 0.035}};
    for (std::size_t i = 0; i < 3; ++i) {
      add_bone(side + " ear" + std::to_string(i), i == 0 ? "head" : side + " ear" + std::to_string(i - 1), ear[i],
               0.06);
      add_flesh(ear[i], ear[i + 1], radius[i], radius[i + 1], i == 0 ? 0.05 : 0.01);
    }
  }

  std::vector<Bone> m_bones;
  std::vector<Flesh> m_flesh;
};

} // namespace internal
} // namespace Animated_mesh_generators

#endif // ANIMATED_MESH_GENERATORS_INTERNAL_FIGURE_BODY_H
