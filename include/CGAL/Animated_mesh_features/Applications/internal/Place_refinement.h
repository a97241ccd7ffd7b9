// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_PLACE_REFINEMENT_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_PLACE_REFINEMENT_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_positions.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_quadrics.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Triangle_tree.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Draws the vertices of a level to where its triangles are nearest to the original, over samples of both surfaces (H. Hoppe
// and others, Mesh optimization, 1993). Quadrics are of planes, which reach far beyond the triangles that they come from:
// where many were summed up, their least value is not where the surface is.
//
// Samples are the vertices of either surface and the centres of its triangles, unless these are small, each with the
// nearest point of the other one near by; n is the unit vector between them, e their distance. If the corners of the
// level's triangle move by d_i, the distance becomes e + n . sum b_i d_i, with the barycentric coordinates b_i of the
// sample. Its square is convex, so it is no more than sum b_i (e + n . d_i)^2: a plane for each corner, and all corners move
// at the same time.
//
// It is the mean distance that is to be small, not the mean square, of which a few far samples are most. So a square counts
// by 1 / (e + s), where s is twice the mean distance in the pose: what becomes less is the sum of e - s log(1 + e / s), of
// distances where they are large (R. C. Fair, On the robust estimation of econometric models, 1974), for such weights
// bound it by squares that touch it at e.
class Place_refinement
{
public:
  typedef Rest_shape::Index Index;

  // `triangles`: of the level, by ranks of vertices of the original. `survivors`: of each vertex of the original the one
  // in whose place it is. The rest shape is kept by reference.
  Place_refinement(const Rest_shape& rest, const std::vector<Rest_shape::Triangle>& triangles,
                   const std::vector<Index>& survivors)
    : m_rest(&rest)
    , m_triangles(triangles)
    , m_number_of(survivors.size(), Rest_shape::none)
  {
    for (Rest_shape::Triangle& t : m_triangles)
      for (Index& v : t) {
        Index& number = m_number_of[v];
        if (number == Rest_shape::none) {
          number = Index(m_vertices.size());
          m_vertices.push_back(v);
        }
        v = number;
      }
    for (std::size_t v = 0; v < survivors.size(); ++v) m_number_of[v] = m_number_of[survivors[v]];
    std::vector<std::vector<Index>> around(m_vertices.size()), taken(m_vertices.size());
    for (std::size_t t = 0; t < m_triangles.size(); ++t)
      for (Index k : m_triangles[t]) around[k].push_back(Index(t));
    for (std::size_t v = 0; v < survivors.size(); ++v)
      if (m_number_of[v] != Rest_shape::none && !rest.is_isolated(v)) taken[m_number_of[v]].push_back(Index(v));
    for (const auto& row : around) m_around.push_back(row.begin(), row.end());
    for (const auto& row : taken) m_taken.push_back(row.begin(), row.end());
    double area = 0;
    std::vector<double> areas;
    for (const Triangle& t : rest.triangles()) {
      const auto& p = rest.points();
      areas.push_back((p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm());
      area += areas.back();
    }
    const double small = 1. / 8; // of a triangle of the level
    for (double a : areas) m_has_centre.push_back(a > small * area / double(m_triangles.size()) ? 1 : 0);
  }

  // of the level, by number
  const std::vector<Index>& vertices() const { return m_vertices; }

  // of the level, of numbers of its vertices
  const std::vector<Rest_shape::Triangle>& triangles() const { return m_triangles; }

  // the triangles around vertex `k` of the level
  Compressed_rows::Row around(std::size_t k) const { return m_around[k]; }

  // Adds the planes to which the vertices of the level are drawn in one pose, by number. `weight(v)`: how much the original
  // matters at a vertex. O(N) time and memory.
  template <class Weight>
  void add_planes(const Pose_positions& original, const Pose_positions& current, std::size_t pose, const Weight& weight,
                  Pose_quadrics& quadrics) const
  {
    Pose_surfaces at;
    for (std::size_t v = 0; v < m_number_of.size(); ++v) {
      at.original.push_back(point(original, v, pose));
      at.weights.push_back(weight(v));
    }
    for (Index v : m_vertices) at.level.push_back(point(current, v, pose));
    std::vector<Sample> samples;
    sample_original(at, samples);
    sample_level(at, samples);
    double sum = 0, area = 0;
    for (const Sample& s : samples) {
      sum += s.weight * s.distance;
      area += s.weight;
    }
    if (!(area > 0)) return;
    const double small = (std::max)(far_of_mean * sum / area, touching);
    for (const Sample& s : samples)
      for (std::size_t i = 0; i < 3; ++i)
        if (s.place[i] > 0)
          quadrics.add_plane(s.corners[i], pose, s.normal, at.level[s.corners[i]] - s.distance * s.normal,
                             s.place[i] * s.weight / (s.distance + small));
  }

private:
  typedef Rest_shape::Point Point;
  typedef Rest_shape::Triangle Triangle;

  struct Pose_surfaces
  {
    std::vector<Point> original, level;
    std::vector<double> weights; // of the original
  };

  // A point of either surface and the nearest one of the other.
  struct Sample
  {
    Triangle corners;            // of the level, by number
    std::array<double, 3> place; // barycentric coordinates of the level's point
    Point normal;                // unit vector from the original to the level; that of the triangle where they touch
    double distance, weight;
  };

  // Distances above so many means are large. With one, more of the mean is gained on meshes that crumple, and lost from the
  // largest distances of all.
  static constexpr double far_of_mean = 2;
  // nearer than this, in the unit of positions, surfaces touch
  static constexpr double touching = 1e-6;
  // A square of a linear function has the mean of 3/4 of its value at the centre of a triangle and 1/12 of those at
  // the corners.
  static constexpr double centre_share = 3. / 4, corner_share = 1. / 12;

  static Point point(const Pose_positions& positions, std::size_t v, std::size_t pose)
  {
    const std::array<double, 3> x = positions.point(v, pose);
    return Point(x[0], x[1], x[2]);
  }

  void sample_original(const Pose_surfaces& at, std::vector<Sample>& samples) const
  {
    std::vector<double> shares(at.original.size(), 0);
    for (std::size_t k = 0; k < m_has_centre.size(); ++k) {
      const Triangle& t = m_rest->triangles()[k];
      const Point &a = at.original[t[0]], &b = at.original[t[1]], &c = at.original[t[2]];
      const double area = (b - a).cross(c - a).norm() / 2;
      double sum = 0;
      for (Index v : t) {
        const double w = at.weights[v] * area;
        shares[v] += m_has_centre[k] != 0 ? corner_share * w : w / 3;
        sum += w / 3;
      }
      if (m_has_centre[k] != 0)
        sample(at, (a + b + c) / 3, {{m_number_of[t[0]], m_number_of[t[1]], m_number_of[t[2]]}}, centre_share * sum,
               samples);
    }
    for (std::size_t v = 0; v < shares.size(); ++v) {
      const Index k = m_number_of[v];
      if (shares[v] > 0) sample(at, at.original[v], {{k, k, k}}, shares[v], samples);
    }
  }

  // `near`: numbers of vertices around which the nearest point is looked for
  void sample(const Pose_surfaces& at, const Point& p, const Triangle& near, double weight,
              std::vector<Sample>& samples) const
  {
    double least = (std::numeric_limits<double>::max)();
    Point nearest = p;
    Index triangle = Rest_shape::none;
    for (std::size_t i = 0; i < 3; ++i) {
      if (near[i] == Rest_shape::none || (i > 0 && near[i] == near[0]) || (i > 1 && near[i] == near[1])) continue;
      for (Index t : m_around[near[i]]) {
        const Triangle& c = m_triangles[t];
        const Point q = nearest_in_triangle(p, at.level[c[0]], at.level[c[1]], at.level[c[2]]);
        const double square = (q - p).squaredNorm();
        if (square < least) least = square, nearest = q, triangle = t;
      }
    }
    if (triangle == Rest_shape::none) return;
    const Triangle& c = m_triangles[triangle];
    const Point x[3] = {at.level[c[0]], at.level[c[1]], at.level[c[2]]};
    const Point normal = (x[1] - x[0]).cross(x[2] - x[0]);
    const double nn = normal.squaredNorm();
    if (!(nn > 0)) return;
    Sample s = between(p, nearest, normal / std::sqrt(nn));
    s.corners = c;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& next = x[(i + 1) % 3];
      s.place[i] = (x[(i + 2) % 3] - next).cross(nearest - next).dot(normal) / nn;
    }
    s.weight = weight;
    samples.push_back(s);
  }

  // Without these, what no sample of the original is near to would go anywhere.
  void sample_level(const Pose_surfaces& at, std::vector<Sample>& samples) const
  {
    std::vector<double> shares(at.level.size(), 0);
    for (const Triangle& t : m_triangles) {
      const Point &a = at.level[t[0]], &b = at.level[t[1]], &c = at.level[t[2]], centre = (a + b + c) / 3;
      const Point normal = (b - a).cross(c - a);
      const double area = normal.norm() / 2;
      for (Index k : t) shares[k] += corner_share * area;
      if (!(area > 0)) continue;
      const Index v = nearest_taken(at, centre, t);
      Sample s = between(nearest_around(at, centre, v), centre, normal / (2 * area));
      s.corners = t;
      s.place = {{1. / 3, 1. / 3, 1. / 3}};
      s.weight = at.weights[v] * centre_share * area;
      samples.push_back(s);
    }
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const Index v = nearest_taken(at, at.level[k], {{Index(k), Index(k), Index(k)}});
      Sample s = between(nearest_around(at, at.level[k], v), at.level[k], Point(0, 0, 0));
      s.corners = {{Index(k), Index(k), Index(k)}};
      s.place = {{1, 0, 0}};
      s.weight = at.weights[v] * shares[k];
      samples.push_back(s);
    }
  }

  // `normal`: where they touch
  static Sample between(const Point& original, const Point& level, const Point& normal)
  {
    Sample s;
    const Point step = level - original;
    s.distance = step.norm();
    const bool touches = !(s.distance > touching);
    s.normal = touches ? normal : Point(step / s.distance);
    if (touches) s.distance = 0;
    return s;
  }

  // of the vertices whose place these have taken, the one nearest to p
  Index nearest_taken(const Pose_surfaces& at, const Point& p, const Triangle& near) const
  {
    double least = (std::numeric_limits<double>::max)();
    Index nearest = m_vertices[near[0]];
    for (std::size_t i = 0; i < 3; ++i) {
      if (i > 0 && near[i] == near[0]) continue;
      for (Index v : m_taken[near[i]]) {
        const double square = (at.original[v] - p).squaredNorm();
        if (square < least) least = square, nearest = v;
      }
    }
    return nearest;
  }

  // the nearest point of the original's triangles around a vertex
  Point nearest_around(const Pose_surfaces& at, const Point& p, Index v) const
  {
    double least = (std::numeric_limits<double>::max)();
    Point nearest = at.original[v];
    for (Index t : m_rest->incident_triangles()[v]) {
      const Triangle& c = m_rest->triangles()[t];
      const Point q = nearest_in_triangle(p, at.original[c[0]], at.original[c[1]], at.original[c[2]]);
      const double square = (q - p).squaredNorm();
      if (square < least) least = square, nearest = q;
    }
    return nearest;
  }

  const Rest_shape* m_rest;
  std::vector<Triangle> m_triangles;
  std::vector<Index> m_number_of; // for each vertex of the original that of the vertex in whose place it is
  std::vector<Index> m_vertices;
  std::vector<char> m_has_centre; // for each triangle of the original whether it is sampled there
  Compressed_rows m_around, m_taken;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_PLACE_REFINEMENT_H
