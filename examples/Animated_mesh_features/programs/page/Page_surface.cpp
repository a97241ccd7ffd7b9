// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/Page_surface.h"

#include "page/thinned_triangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace Programs {

namespace {

constexpr std::size_t sampled_frames = 4;

Eigen::Vector3d point_in_frame(const Shown_sequence& sequence, std::size_t v, std::size_t f)
{
  const auto& animation = sequence.trajectories();
  return {animation.x(v, f), animation.y(v, f), animation.z(v, f)};
}

// Where bends appear: the rest shape, and a few frames, evenly.
std::vector<std::vector<Eigen::Vector3f>> sampled_shapes(const Shown_sequence& sequence)
{
  std::vector<std::vector<Eigen::Vector3f>> shapes(1);
  for (const auto& p : sequence.rest_shape().points()) shapes[0].push_back(p.cast<float>());
  const std::size_t n = sequence.number_of_vertices(), frames = sequence.number_of_frames();
  for (std::size_t i = 0; i < (std::min)(sampled_frames, frames); ++i) {
    const std::size_t f = (2 * i + 1) * frames / (2 * (std::min)(sampled_frames, frames));
    // single precision is enough near the origin
    const Eigen::Vector3d origin = point_in_frame(sequence, 0, f);
    shapes.emplace_back();
    for (std::size_t v = 0; v < n; ++v) shapes.back().push_back((point_in_frame(sequence, v, f) - origin).cast<float>());
  }
  return shapes;
}

// The nearest point of a triangle, as weights of its corners (C. Ericson, Real-Time Collision Detection, 2005, 5.1.5).
Eigen::Vector3d nearest_weights(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c)
{
  const auto on_edge = [&](const Eigen::Vector3d& q, const Eigen::Vector3d& r) {
    const double length = (r - q).squaredNorm();
    return length > 0 ? (std::min)((std::max)((p - q).dot(r - q) / length, 0.), 1.) : 0.;
  };
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  if (area > 0) {
    const double v = normal.dot((p - a).cross(c - a)) / area, w = normal.dot((b - a).cross(p - a)) / area;
    if (v >= 0 && w >= 0 && v + w <= 1) return {1 - v - w, v, w};
  }
  const double ab = on_edge(a, b), bc = on_edge(b, c), ca = on_edge(c, a);
  const Eigen::Vector3d candidates[] = {{1 - ab, ab, 0}, {0, 1 - bc, bc}, {ca, 0, 1 - ca}};
  Eigen::Vector3d best = candidates[0];
  double least = (std::numeric_limits<double>::max)();
  for (const Eigen::Vector3d& weights : candidates) {
    const double distance = (weights[0] * a + weights[1] * b + weights[2] * c - p).squaredNorm();
    if (distance < least) {
      least = distance;
      best = weights;
    }
  }
  return best;
}

} // namespace

Page_surface::Page_surface(const Shown_sequence& sequence, std::size_t most_vertices)
  : m_sequence(sequence)
  , m_vertices(sequence.number_of_vertices())
  , m_triangles(sequence.rest_shape().triangles())
{
  std::iota(m_vertices.begin(), m_vertices.end(), std::size_t(0));
  if (m_vertices.size() > most_vertices) thin(most_vertices);
}

void Page_surface::thin(std::size_t most_vertices)
{
  m_triangles = thinned_triangles(std::move(m_triangles), sampled_shapes(m_sequence), most_vertices);
  std::vector<std::uint32_t> rank(m_vertices.size(), 0);
  for (const auto& t : m_triangles)
    for (std::uint32_t v : t) rank[v] = 1;
  m_vertices.clear();
  for (std::size_t v = 0; v < rank.size(); ++v)
    if (rank[v] != 0) {
      rank[v] = static_cast<std::uint32_t>(m_vertices.size());
      m_vertices.push_back(v);
    }
  for (auto& t : m_triangles)
    for (std::uint32_t& v : t) v = rank[v];
  m_is_thinned = true;
}

Page_surface::Place Page_surface::place(const Shown_feature& feature) const
{
  if (!m_is_thinned) return {feature.triangle, feature.barycentric_coordinates};
  const auto& rest = m_sequence.rest_shape().points();
  const auto on = [&](const auto& corner) {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) p += feature.barycentric_coordinates[i] * corner(feature.triangle[i]);
    return p;
  };
  const auto at_rest = [&](std::size_t v) { return rest[v]; };
  const auto moving = [&](std::size_t v) { return point_in_frame(m_sequence, v, feature.frame); };
  const Eigen::Vector3d p = on(at_rest), q = on(moving);
  double least = (std::numeric_limits<double>::max)();
  Place best{{{0, 0, 0}}, {{1, 0, 0}}};
  for (const auto& t : m_triangles) {
    const std::size_t v[] = {m_vertices[t[0]], m_vertices[t[1]], m_vertices[t[2]]};
    const Eigen::Vector3d w = nearest_weights(p, rest[v[0]], rest[v[1]], rest[v[2]]);
    // on sheets that touch each other in one of the shapes, the other one tells
    const Eigen::Vector3d off = w[0] * rest[v[0]] + w[1] * rest[v[1]] + w[2] * rest[v[2]] - p;
    double distance = off.squaredNorm();
    if (!(distance < least)) continue;
    distance += (w[0] * moving(v[0]) + w[1] * moving(v[1]) + w[2] * moving(v[2]) - q).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    best = {{{t[0], t[1], t[2]}}, {{w[0], w[1], w[2]}}};
  }
  return best;
}

} // namespace Programs
