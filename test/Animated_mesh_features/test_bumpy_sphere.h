// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_TEST_BUMPY_SPHERE_H
#define CGAL_ANIMATED_MESH_FEATURES_TEST_BUMPY_SPHERE_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// A small animation to be carried by any mesh: an uneven sphere on which bumps rise and fall. It has no symmetry, so that
// no two samples are equal but for rounding, and all its coordinates are numbers of type float, which every kernel
// represents.

namespace test_support {

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;

struct Bump
{
  std::array<double, 3> direction; // of its place, seen from the middle of the sphere
  double width, height;            // the standard deviation of a Gaussian and its amplitude (length)
  double time, duration;           // the same in time (seconds)
};

struct Bumpy_sphere
{
  std::vector<Point_3> rest;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::vector<Point_3>> frames;
  double frame_duration = 1. / 24;
  std::vector<Bump> bumps = {{{{0.9, 0.3, 0.2}}, 0.25, 0.20, 0.40, 0.07},
                             {{{-0.5, 0.7, -0.4}}, 0.35, 0.30, 0.60, 0.11}};

  // 10 * 4^n + 2 vertices
  explicit Bumpy_sphere(int subdivisions = 3, std::size_t number_of_frames = 24)
  {
    make_icosahedron();
    for (int i = 0; i < subdivisions; ++i) subdivide();
    for (Point_3& p : rest) p = uneven(p);
    for (std::size_t f = 0; f < number_of_frames; ++f) {
      std::vector<Point_3> frame;
      for (const Point_3& p : rest) frame.push_back(moved(p, double(f) * frame_duration));
      frames.push_back(frame);
    }
  }

  // the place of a bump on the sphere at rest
  Point_3 place(const Bump& b) const { return uneven(Point_3(b.direction[0], b.direction[1], b.direction[2])); }

private:
  static Point_3 rounded(double x, double y, double z) { return Point_3(float(x), float(y), float(z)); }

  static Point_3 uneven(const Point_3& p)
  {
    const double l = std::sqrt(p.x() * p.x() + p.y() * p.y() + p.z() * p.z());
    const double x = p.x() / l, y = p.y() / l, z = p.z() / l;
    const double r = 1 + 0.05 * std::sin(2.3 * x + 0.4) + 0.06 * std::cos(1.7 * y - 2.1 * z + 0.3);
    return rounded(r * x, r * y, r * z);
  }

  Point_3 moved(const Point_3& p, double time) const
  {
    double lift = 0;
    for (const Bump& b : bumps) {
      const Point_3 c = place(b);
      const double s = std::pow(p.x() - c.x(), 2) + std::pow(p.y() - c.y(), 2) + std::pow(p.z() - c.z(), 2);
      lift += b.height * std::exp(-s / (2 * b.width * b.width)) *
              std::exp(-std::pow(time - b.time, 2) / (2 * b.duration * b.duration));
    }
    return rounded((1 + lift) * p.x(), (1 + lift) * p.y(), (1 + lift) * p.z());
  }

  void make_icosahedron()
  {
    const double g = (1 + std::sqrt(5.)) / 2;
    for (int s : {-1, 1})
      for (int t : {-1, 1}) {
        rest.emplace_back(0, s, t * g);
        rest.emplace_back(s, t * g, 0);
        rest.emplace_back(t * g, 0, s);
      }
    const auto side = [&](std::size_t i, std::size_t j) {
      return std::abs(CGAL::squared_distance(rest[i], rest[j]) - 4) < 1e-9;
    };
    for (std::size_t i = 0; i < rest.size(); ++i)
      for (std::size_t j = i + 1; j < rest.size(); ++j)
        for (std::size_t k = j + 1; k < rest.size(); ++k) {
          if (!side(i, j) || !side(j, k) || !side(k, i)) continue;
          if (CGAL::orientation(Point_3(0, 0, 0), rest[i], rest[j], rest[k]) == CGAL::POSITIVE)
            triangles.push_back({{i, j, k}});
          else
            triangles.push_back({{i, k, j}});
        }
  }

  void subdivide()
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t i, std::size_t j) {
      const auto inserted = middles.emplace(std::minmax(i, j), rest.size());
      if (inserted.second) {
        const Point_3 m = CGAL::midpoint(rest[i], rest[j]);
        const double l = std::sqrt(CGAL::squared_distance(m, Point_3(0, 0, 0)));
        rest.emplace_back(m.x() / l, m.y() / l, m.z() / l);
      }
      return inserted.first->second;
    };
    std::vector<std::array<std::size_t, 3>> finer;
    for (const auto& t : triangles) {
      const std::size_t a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      finer.push_back({{t[0], a, c}});
      finer.push_back({{t[1], b, a}});
      finer.push_back({{t[2], c, b}});
      finer.push_back({{a, b, c}});
    }
    triangles.swap(finer);
  }
};

// Adds the sphere at rest to a mesh, with points of the mesh's own type. Returns the descriptors of its vertices.
template <class Mesh>
std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> add_sphere(const Bumpy_sphere& sphere, Mesh& mesh)
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor Vertex;
  typedef typename boost::property_map<Mesh, CGAL::vertex_point_t>::type Point_map;
  typedef typename boost::property_traits<Point_map>::value_type Point;
  const Point_map points = get(CGAL::vertex_point, mesh);
  std::vector<Vertex> v;
  for (const Point_3& p : sphere.rest) {
    v.push_back(add_vertex(mesh));
    put(points, v.back(), Point(p.x(), p.y(), p.z()));
  }
  for (const auto& t : sphere.triangles)
    CGAL::Euler::add_face(std::array<Vertex, 3>{{v[t[0]], v[t[1]], v[t[2]]}}, mesh);
  return v;
}

} // namespace test_support

#endif // CGAL_ANIMATED_MESH_FEATURES_TEST_BUMPY_SPHERE_H
