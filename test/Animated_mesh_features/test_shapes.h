// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_TEST_SHAPES_H
#define CGAL_ANIMATED_MESH_FEATURES_TEST_SHAPES_H

#include "test_support.h"

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

// Surfaces with known answers, for the tests of the parts.

namespace test_support {

const double pi = 3.14159265358979323846;

typedef Eigen::Vector3d Vec;
typedef std::vector<Vec> Points;
typedef std::vector<std::array<int, 3>> Faces;
typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

// The same numbers on every platform, unlike the distributions of <random>.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : m_state(seed)
  {}

  std::uint32_t bits()
  {
    m_state = m_state * 6364136223846793005ull + 1442695040888963407ull; // Knuth's MMIX
    return std::uint32_t(m_state >> 32);
  }
  double operator()(double from = 0, double to = 1) { return from + (to - from) * (bits() + 0.5) / 4294967296.; }
  std::size_t below(std::size_t n) { return std::size_t(operator()(0, double(n))); }
  Vec vector(double size = 1)
  {
    const double x = operator()(-size, size), y = operator()(-size, size), z = operator()(-size, size);
    return Vec(x, y, z);
  }
  // uniform in [from, to] on a logarithmic scale
  double power(double from, double to) { return from * std::pow(to / from, operator()()); }
  Eigen::AngleAxisd rotation()
  {
    const Vec axis = vector();
    return Eigen::AngleAxisd(operator()(-pi, pi), axis.normalized());
  }

private:
  std::uint64_t m_state;
};

struct Shape
{
  Points points;
  Faces faces;

  // appends another shape, moved
  void add(Shape other, const Vec& shift = Vec::Zero()) // a copy, since it may be this one
  {
    const int n = int(points.size());
    for (const Vec& p : other.points) points.push_back(p + shift);
    for (const auto& f : other.faces) faces.push_back({{f[0] + n, f[1] + n, f[2] + n}});
  }
};

inline Mesh mesh_of(const Shape& shape)
{
  Mesh mesh;
  for (const Vec& p : shape.points) mesh.add_vertex(Point_3(p[0], p[1], p[2]));
  for (const auto& f : shape.faces)
    CHECK(mesh.add_face(Mesh::Vertex_index(f[0]), Mesh::Vertex_index(f[1]), Mesh::Vertex_index(f[2])) !=
          Mesh::null_face());
  return mesh;
}

inline CGAL::Animated_mesh_features::Rest_shape rest_shape_of(const Shape& shape)
{
  const Mesh mesh = mesh_of(shape);
  const auto index = get(boost::vertex_index, mesh);
  CGAL::Animated_mesh_features::Rest_shape rest(mesh, index, shape.points.size());
  rest.set_points(shape.points);
  return rest;
}

inline std::vector<std::vector<Point_3>> frames_of(const std::vector<Points>& frames)
{
  std::vector<std::vector<Point_3>> result(frames.size());
  for (std::size_t f = 0; f < frames.size(); ++f)
    for (const Vec& p : frames[f]) result[f].emplace_back(p[0], p[1], p[2]);
  return result;
}

template <class Map>
Points mapped(const Points& points, const Map& map)
{
  Points result;
  for (const Vec& p : points) result.push_back(map(p));
  return result;
}

// A patch of the plane z = 0 of equilateral triangles with edges of length h: (columns + 1) x (rows + 1) points, point
// [row * (columns + 1) + column], every other row moved by half an edge.
inline Shape regular_plane(int columns, int rows, double h = 1)
{
  Shape s;
  const int stride = columns + 1;
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c <= columns; ++c) s.points.emplace_back(h * (c + 0.5 * (r % 2)), h * r * std::sqrt(0.75), 0);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const int a = r * stride + c, b = a + 1, d = a + stride, e = d + 1;
      if (r % 2 == 0) {
        s.faces.push_back({{a, b, d}});
        s.faces.push_back({{b, e, d}});
      } else {
        s.faces.push_back({{a, b, e}});
        s.faces.push_back({{a, e, d}});
      }
    }
  return s;
}

// The unit square with n x n cells, diagonals at random and points off the grid by up to `jitter` cells; 0.3 keeps all
// triangles upright.
inline Shape irregular_square(int n, Random& random, double jitter = 0.3)
{
  Shape s;
  for (int r = 0; r <= n; ++r)
    for (int c = 0; c <= n; ++c) {
      const double x = (c + (c > 0 && c < n ? random(-jitter, jitter) : 0)) / n;
      const double y = (r + (r > 0 && r < n ? random(-jitter, jitter) : 0)) / n;
      s.points.emplace_back(x, y, 0);
    }
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c) {
      const int a = r * (n + 1) + c, b = a + 1, d = a + n + 1, e = d + 1;
      if (random() < 0.5) {
        s.faces.push_back({{a, b, d}});
        s.faces.push_back({{b, e, d}});
      } else {
        s.faces.push_back({{a, b, e}});
        s.faces.push_back({{a, e, d}});
      }
    }
  return s;
}

// A sphere of radius 1, from an octahedron: 4^(subdivisions + 1) + 2 points.
inline Shape sphere(int subdivisions)
{
  Shape s;
  s.points = {Vec(1, 0, 0), Vec(-1, 0, 0), Vec(0, 1, 0), Vec(0, -1, 0), Vec(0, 0, 1), Vec(0, 0, -1)};
  s.faces = {{{0, 2, 4}}, {{2, 1, 4}}, {{1, 3, 4}}, {{3, 0, 4}}, {{2, 0, 5}}, {{1, 2, 5}}, {{3, 1, 5}}, {{0, 3, 5}}};
  for (int level = 0; level < subdivisions; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto found = middles.emplace(std::minmax(a, b), int(s.points.size()));
      if (found.second) s.points.push_back((s.points[a] + s.points[b]).normalized());
      return found.first->second;
    };
    Faces faces;
    for (const auto& f : s.faces) {
      const int a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
      const Faces four = {{{f[0], a, c}}, {{a, f[1], b}}, {{c, b, f[2]}}, {{a, b, c}}};
      faces.insert(faces.end(), four.begin(), four.end());
    }
    s.faces = faces;
  }
  return s;
}

// An open tube of radius 1 about the z axis, from 0 to `length`; point [ring * around + i].
inline Shape tube(int around, int rings, double length)
{
  Shape s;
  for (int k = 0; k < rings; ++k)
    for (int i = 0; i < around; ++i) {
      const double a = 2 * pi * (i + 0.5 * (k % 2)) / around;
      s.points.emplace_back(std::cos(a), std::sin(a), length * k / (rings - 1));
    }
  for (int k = 0; k + 1 < rings; ++k)
    for (int i = 0; i < around; ++i) {
      const int a = k * around + i, b = k * around + (i + 1) % around, c = a + around, d = b + around;
      if (k % 2 == 0) {
        s.faces.push_back({{a, b, c}});
        s.faces.push_back({{b, d, c}});
      } else {
        s.faces.push_back({{a, b, d}});
        s.faces.push_back({{a, d, c}});
      }
    }
  return s;
}

} // namespace test_support

#endif // CGAL_ANIMATED_MESH_FEATURES_TEST_SHAPES_H
