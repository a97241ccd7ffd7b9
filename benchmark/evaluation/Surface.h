// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_SURFACE_H
#define ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_SURFACE_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

// A triangle mesh in one frame, as detectors of static shapes see it.

namespace Static_detectors {

typedef Eigen::Vector3d Point;
typedef std::array<std::size_t, 3> Triangle; // counterclockwise

// What all frames share.
struct Connectivity
{
  std::vector<Triangle> triangles;
  std::vector<std::vector<std::size_t>> neighbours; // of each vertex, ascending

  Connectivity(std::size_t number_of_vertices, std::vector<Triangle> all)
    : triangles(std::move(all))
    , neighbours(number_of_vertices)
  {
    for (const Triangle& t : triangles)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          if (i != j) neighbours[t[i]].push_back(t[j]);
    for (std::vector<std::size_t>& n : neighbours) {
      std::sort(n.begin(), n.end());
      n.erase(std::unique(n.begin(), n.end()), n.end());
    }
  }
};

struct Surface
{
  const Connectivity& connectivity;
  std::vector<Point> points;
  double diagonal; // of the bounding box of the rest shape, so that lengths are the same in all frames

  std::size_t size() const { return points.size(); }
  const std::vector<std::size_t>& neighbours(std::size_t v) const { return connectivity.neighbours[v]; }
};

// Areas, normals and mean curvatures of vertices.
struct Vertex_measures
{
  std::vector<double> areas;          // what is nearest to the vertex
  std::vector<Point> normals;         // of length 1, or 0 where there are no triangles
  std::vector<double> mean_curvature; // half of the sum of the principal ones, positive where convex; 0 without area
};

// The cotangent of the angle at a between b and c, within what a sliver of 1/1000 has.
inline double cotangent(const Point& a, const Point& b, const Point& c)
{
  const double largest = 1000, cosine = (b - a).dot(c - a), sine = (b - a).cross(c - a).norm();
  if (sine * largest <= std::abs(cosine)) return cosine > 0 ? largest : cosine < 0 ? -largest : 0;
  return cosine / sine;
}

// The part of a triangle that is nearest to its corner i, with the circumcentre as its end; of an obtuse triangle
// half if the angle at i is the obtuse one, else a quarter.
inline double corner_area(const Surface& s, const Triangle& t, int i)
{
  const Point &p = s.points[t[i]], &a = s.points[t[(i + 1) % 3]], &b = s.points[t[(i + 2) % 3]];
  const double area = (a - p).cross(b - p).norm() / 2;
  if ((a - p).dot(b - p) < 0) return area / 2;
  if ((p - a).dot(b - a) < 0 || (p - b).dot(a - b) < 0) return area / 4;
  return ((a - p).squaredNorm() * cotangent(b, p, a) + (b - p).squaredNorm() * cotangent(a, p, b)) / 8;
}

// Mean curvature by the cotangent Laplacian of the points, (Delta x) = -2 H n, over these areas (M. Meyer, M.
// Desbrun, P. Schroeder, A. H. Barr, Discrete differential-geometry operators for triangulated 2-manifolds, 2003).
inline Vertex_measures vertex_measures(const Surface& s)
{
  const std::size_t n = s.size();
  Vertex_measures m = {std::vector<double>(n, 0), std::vector<Point>(n, Point::Zero()), std::vector<double>(n, 0)};
  std::vector<Point> laplacian(n, Point::Zero());
  for (const Triangle& t : s.connectivity.triangles) {
    const Point normal = (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]) / 2;
    for (int i = 0; i < 3; ++i) {
      const std::size_t a = t[(i + 1) % 3], b = t[(i + 2) % 3];
      m.areas[t[i]] += corner_area(s, t, i);
      m.normals[t[i]] += normal;
      const Point flow = cotangent(s.points[t[i]], s.points[a], s.points[b]) / 2 * (s.points[b] - s.points[a]);
      laplacian[a] += flow;
      laplacian[b] -= flow;
    }
  }
  for (std::size_t v = 0; v < n; ++v) {
    m.normals[v].normalize();
    if (m.areas[v] > 0) m.mean_curvature[v] = -laplacian[v].dot(m.normals[v]) / (2 * m.areas[v]);
  }
  return m;
}

// The vertices within so many edges of v, with v, by the number of edges.
inline std::vector<std::size_t> rings(const Surface& s, std::size_t v, std::size_t number)
{
  std::vector<std::size_t> all = {v};
  std::size_t first = 0;
  for (std::size_t ring = 0; ring < number; ++ring) {
    const std::size_t last = all.size();
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t w : s.neighbours(all[i]))
        if (std::find(all.begin(), all.end(), w) == all.end()) all.push_back(w);
    first = last;
  }
  return all;
}

// Whether a value is greater than those of all others within so many edges.
inline bool is_maximum(const Surface& s, const std::vector<double>& values, std::size_t v,
                       std::size_t number_of_rings = 1)
{
  if (s.neighbours(v).empty()) return false;
  if (number_of_rings == 1)
    return std::all_of(s.neighbours(v).begin(), s.neighbours(v).end(),
                       [&](std::size_t w) { return values[w] < values[v]; });
  const std::vector<std::size_t> around = rings(s, v, number_of_rings);
  return std::all_of(around.begin() + 1, around.end(), [&](std::size_t w) { return values[w] < values[v]; });
}

} // namespace Static_detectors

#endif // ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_SURFACE_H
