// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/surface_shapes.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace Programs {

std::vector<float> vertex_normals(const std::vector<float>& xyz, const Triangles& triangles)
{
  typedef Eigen::Vector3d Vector;
  std::vector<Vector> sums(xyz.size() / 3, Vector::Zero());
  const auto point = [&](std::size_t v) { return Vector(xyz[3 * v], xyz[3 * v + 1], xyz[3 * v + 2]); };
  for (const auto& t : triangles) {
    const Vector a = point(t[0]), normal = (point(t[1]) - a).cross(point(t[2]) - a);
    for (auto v : t) sums[v] += normal;
  }
  std::vector<float> normals;
  normals.reserve(xyz.size());
  for (const Vector& sum : sums) {
    const double length = sum.stableNorm();
    const Vector n = length > 0 ? Vector(sum / length) : Vector::UnitZ();
    for (int c = 0; c < 3; ++c) normals.push_back(static_cast<float>(n[c]));
  }
  return normals;
}

Unit_sphere::Unit_sphere(int subdivisions)
{
  for (float sign : {1.f, -1.f})
    for (int axis = 0; axis < 3; ++axis)
      for (int c = 0; c < 3; ++c) xyz.push_back(c == axis ? sign : 0);
  corners = {0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2, 1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5};
  for (int i = 0; i < subdivisions; ++i) subdivide();
}

void Unit_sphere::subdivide()
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto inserted = middles.emplace(std::minmax(a, b), std::uint32_t(xyz.size() / 3));
    if (inserted.second) {
      Eigen::Vector3f m;
      for (int c = 0; c < 3; ++c) m[c] = xyz[3 * a + std::size_t(c)] + xyz[3 * b + std::size_t(c)];
      m.normalize();
      xyz.insert(xyz.end(), m.data(), m.data() + 3);
    }
    return inserted.first->second;
  };
  std::vector<std::uint32_t> finer;
  for (std::size_t t = 0; t < corners.size(); t += 3) {
    const std::uint32_t a = corners[t], b = corners[t + 1], c = corners[t + 2];
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
  }
  corners = std::move(finer);
}

} // namespace Programs
