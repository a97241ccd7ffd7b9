// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_MEASURED_SURFACE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_MEASURED_SURFACE_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Surface_samples.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Triangle_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// One of the two surfaces, as it is in a frame.
class Measured_surface
{
public:
  typedef Rest_shape::Point Point;

  Measured_surface(const std::vector<Rest_shape::Triangle>& triangles, const std::vector<Point>& rest)
    : m_triangles(&triangles)
    , m_points(rest)
    , m_tree(triangles, m_points)
  {}

  Measured_surface(const Measured_surface&) = delete;
  Measured_surface& operator=(const Measured_surface&) = delete;

  void follow(std::vector<Point> points)
  {
    m_points = std::move(points);
    m_tree.follow(m_points);
    m_normals.clear();
    for (const Rest_shape::Triangle& t : *m_triangles)
      m_normals.push_back((m_points[t[1]] - m_points[t[0]]).cross(m_points[t[2]] - m_points[t[0]]) / 2);
  }

  const Triangle_tree& tree() const { return m_tree; }
  const std::vector<Point>& normals() const { return m_normals; } // as long as areas

  Point point(const Surface_samples::Sample& s) const
  {
    const Rest_shape::Triangle& t = (*m_triangles)[s.triangle];
    return s.place[0] * m_points[t[0]] + s.place[1] * m_points[t[1]] + s.place[2] * m_points[t[2]];
  }

private:
  const std::vector<Rest_shape::Triangle>* m_triangles;
  std::vector<Point> m_points, m_normals;
  Triangle_tree m_tree;
};

// Calls use(sample, its number, area, distance, angle between normals or negative).
template <class Use>
void measure_samples(const Surface_samples& from, const Measured_surface& source, const Measured_surface& target,
                     std::vector<Rest_shape::Index>& guesses, const Use& use)
{
  guesses.resize(from.samples.size(), Rest_shape::none);
  for (std::size_t i = 0; i < from.samples.size(); ++i) {
    const Surface_samples::Sample& s = from.samples[i];
    const Triangle_tree::Nearest nearest = target.tree().nearest(source.point(s), guesses[i]);
    guesses[i] = nearest.triangle;
    const Rest_shape::Point &n = source.normals()[s.triangle], &m = target.normals()[nearest.triangle];
    const double lengths = n.norm() * m.norm();
    const double cosine = lengths > 0 ? (std::max)(-1., (std::min)(1., n.dot(m) / lengths)) : 1;
    use(s, s.share * n.norm(), std::sqrt(nearest.square), cosine);
  }
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_MEASURED_SURFACE_H
