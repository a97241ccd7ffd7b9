// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VIEW_SPHERE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VIEW_SPHERE_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesViews

Directions that are spread over the sphere: an icosahedron, of which every triangle was divided in four some times. With
each direction its opposite is among them, to the last bit, so that a surface that was projected once serves for both.
*/
class View_sphere
{
public:
  typedef std::array<std::uint32_t, 3> Triangle; ///< of ranks of directions

  /// divides `subdivisions` times: \f$10 \cdot 4^n + 2\f$ directions, 162 for 2, 642 for 3, 2,562 for 4.
  /// \throw Option_error if there are to be more than 6, 40,962 directions.
  explicit View_sphere(std::size_t subdivisions)
  {
    if (subdivisions > 6)
      throw Option_error("a sphere of directions cannot be subdivided " + std::to_string(subdivisions) +
                         " times; at most 6 times, to 40962 directions");
    make_icosahedron();
    for (std::size_t i = 0; i < subdivisions; ++i) subdivide();
    for (const Triangle& t : m_triangles)
      for (std::size_t i = 0; i < 3; ++i)
        m_longest_edge = (std::max)(m_longest_edge, angle(m_directions[t[i]], m_directions[t[(i + 1) % 3]]));
  }

  /// unit vectors, from the body to the camera.
  const std::vector<Eigen::Vector3d>& directions() const& { return m_directions; }

  /// the same of a sphere that is not kept.
  std::vector<Eigen::Vector3d> directions() && { return std::move(m_directions); }

  /// the triangles between them.
  const std::vector<Triangle>& triangles() const { return m_triangles; }

  /// the largest angle between two neighbours (radians).
  double longest_edge() const { return m_longest_edge; }

  /// the angle between two directions (radians), also of nearly equal ones.
  static double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
  {
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

private:
  void make_icosahedron()
  {
    const double golden_ratio = (1 + std::sqrt(5.)) / 2;
    for (int i = 0; i < 3; ++i)
      for (double a : {-1., 1.})
        for (double b : {-golden_ratio, golden_ratio}) {
          Eigen::Vector3d p = Eigen::Vector3d::Zero();
          p[(i + 1) % 3] = a, p[(i + 2) % 3] = b;
          m_directions.push_back(p / std::sqrt(1 + golden_ratio * golden_ratio));
        }
    // All triples of corners at the distance of an edge, seen from outside counterclockwise.
    const auto is_edge = [&](std::size_t i, std::size_t j) {
      const double cosine = m_directions[i].dot(m_directions[j]); // 1/sqrt(5), or -1/sqrt(5) and less
      return cosine > 0 && cosine < 0.9;
    };
    for (std::uint32_t i = 0; i < 12; ++i)
      for (std::uint32_t j = i + 1; j < 12; ++j)
        for (std::uint32_t k = j + 1; k < 12; ++k) {
          if (!is_edge(i, j) || !is_edge(j, k) || !is_edge(i, k)) continue;
          const bool is_outward = m_directions[i].cross(m_directions[j]).dot(m_directions[k]) > 0;
          m_triangles.push_back(is_outward ? Triangle{{i, j, k}} : Triangle{{i, k, j}});
        }
  }

  void subdivide()
  {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t i, std::uint32_t j) {
      const auto at = middles.emplace(std::minmax(i, j), std::uint32_t(m_directions.size()));
      if (at.second) m_directions.push_back((m_directions[i] + m_directions[j]).normalized());
      return at.first->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : m_triangles) {
      const std::uint32_t a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      for (const Triangle& part :
           {Triangle{{t[0], a, c}}, Triangle{{a, t[1], b}}, Triangle{{c, b, t[2]}}, Triangle{{a, b, c}}})
        finer.push_back(part);
    }
    m_triangles.swap(finer);
  }

  std::vector<Eigen::Vector3d> m_directions;
  std::vector<Triangle> m_triangles;
  double m_longest_edge = 0;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VIEW_SPHERE_H
