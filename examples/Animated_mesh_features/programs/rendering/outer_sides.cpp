// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/outer_sides.h"

#include <Eigen/Geometry>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

namespace Programs::Rendering {

namespace {

// A connected part of the surface.
struct Part
{
  double border = 0, volume = 0; // length; times 6
  Eigen::Vector3d low = Eigen::Vector3d::Constant((std::numeric_limits<double>::max)()), high = -low;

  std::int8_t outer_side() const
  {
    const double most = 0.1; // of the diagonal of its bounding box
    if (border > most * (high - low).norm()) return 0;
    return volume > 0 ? 1 : volume < 0 ? -1 : 0;
  }
};

// The edges that one triangle has.
std::vector<std::uint64_t> border_edges(const std::vector<Surface::Triangle>& triangles)
{
  std::vector<std::uint64_t> edges, border;
  edges.reserve(3 * triangles.size());
  for (const Surface::Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto ends = std::minmax(t[i], t[(i + 1) % 3]);
      edges.push_back(std::uint64_t(ends.first) << 32 | ends.second);
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i)
    if ((i == 0 || edges[i - 1] != edges[i]) && (i + 1 == edges.size() || edges[i + 1] != edges[i]))
      border.push_back(edges[i]);
  return border;
}

} // namespace

std::vector<std::int8_t> outer_sides(const std::vector<Eigen::Vector3d>& points,
                                     const std::vector<Surface::Triangle>& triangles)
{
  std::vector<std::size_t> rank(points.size(), 0), parent(points.size());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
  for (const Surface::Triangle& t : triangles) {
    sets.union_set(std::size_t(t[0]), std::size_t(t[1]));
    sets.union_set(std::size_t(t[1]), std::size_t(t[2]));
  }
  std::vector<Part> parts(points.size()); // by their roots
  for (std::size_t v = 0; v < points.size(); ++v) {
    Part& part = parts[sets.find_set(v)];
    part.low = part.low.cwiseMin(points[v]);
    part.high = part.high.cwiseMax(points[v]);
  }
  for (const Surface::Triangle& t : triangles) {
    Part& part = parts[sets.find_set(std::size_t(t[0]))];
    const Eigen::Vector3d middle = (part.low + part.high) / 2; // for what is nearly closed
    part.volume += (points[t[0]] - middle).dot((points[t[1]] - middle).cross(points[t[2]] - middle));
  }
  for (const std::uint64_t e : border_edges(triangles)) {
    const std::size_t a = std::size_t(e >> 32), b = std::size_t(e & 0xffffffffu);
    parts[sets.find_set(a)].border += (points[a] - points[b]).norm();
  }
  std::vector<std::int8_t> sides;
  for (const Surface::Triangle& t : triangles) sides.push_back(parts[sets.find_set(std::size_t(t[0]))].outer_side());
  return sides;
}

} // namespace Programs::Rendering
