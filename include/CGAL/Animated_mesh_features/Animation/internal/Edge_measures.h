// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_EDGE_MEASURES_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_EDGE_MEASURES_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_components.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// What does not change when a surface moves rigidly, and determines it up to a rigid motion: for each edge its length
// and the angle between its triangles, as unit vector (cos, sin). The angle is the one that turns the normal of the
// left triangle into that of the right one about the direction from source to target; positive where convex.
struct Edge_measures
{
  std::vector<double> lengths;
  std::vector<Eigen::Vector2d> angles; // zero where there is none: at borders, and at edges of length zero
};

// The unit normals of all triangles. A triangle whose height is within rounding of zero has no normal of its own: it
// continues its neighbours, turned about its longest edge so as to be perpendicular to it.
inline void triangle_normals(const Rest_shape& shape, const Triangle_adjacency& adjacency,
                             const std::vector<Eigen::Vector3d>& points, std::vector<Eigen::Vector3d>& normals)
{
  // Heights that follow from lengths are lost below the square root of the precision.
  const double flat = std::sqrt(std::numeric_limits<double>::epsilon());
  const std::size_t n = shape.triangles().size();
  normals.resize(n);
  std::vector<std::size_t> without;
  for (std::size_t t = 0; t < n; ++t) {
    const Rest_shape::Triangle& v = shape.triangles()[t];
    const Eigen::Vector3d a = points[v[1]] - points[v[0]], b = points[v[2]] - points[v[0]];
    normals[t] = a.cross(b);
    const double longest = (std::max)({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    if (!(normals[t].norm() > flat * longest)) {
      without.push_back(t);
      normals[t].setZero();
    }
  }
  std::vector<Eigen::Vector3d> continued(without.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < without.size(); ++i) {
    const std::size_t t = without[i];
    const Rest_shape::Triangle& v = shape.triangles()[t];
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    for (unsigned k = 0; k < 3; ++k) {
      const Rest_shape::Index g = adjacency.neighbour(t, k);
      if (g != Rest_shape::none) continued[i] += normals[g]; // areas as weights
      const Eigen::Vector3d side = points[v[(k + 1) % 3]] - points[v[k]];
      if (side.squaredNorm() > axis.squaredNorm()) axis = side;
    }
    axis.normalize(); // leaves a zero vector alone
    continued[i] -= axis * axis.dot(continued[i]);
    if (!(continued[i].norm() > 0)) continued[i] = axis.isZero() ? Eigen::Vector3d::UnitZ() : axis.unitOrthogonal();
  }
  for (std::size_t i = 0; i < without.size(); ++i) normals[without[i]] = continued[i];
  for (Eigen::Vector3d& normal : normals) normal.normalize();
}

inline void measure_edges(const Rest_shape& shape, const Triangle_adjacency& adjacency,
                          const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& normals,
                          Edge_measures& measures)
{
  measures.lengths.resize(shape.edges().size());
  measures.angles.assign(shape.edges().size(), Eigen::Vector2d::Zero());
  for (std::size_t i = 0; i < shape.edges().size(); ++i) {
    const Rest_shape::Edge& e = shape.edges()[i];
    const Eigen::Vector3d d = points[e.target] - points[e.source];
    measures.lengths[i] = d.norm();
    if (!adjacency.is_interior(i) || !(measures.lengths[i] > 0)) continue;
    const Eigen::Vector3d& l = normals[adjacency.sides[i][0].triangle];
    const Eigen::Vector3d& r = normals[adjacency.sides[i][1].triangle];
    const Eigen::Vector2d angle(l.dot(r), l.cross(r).dot(d) / measures.lengths[i]);
    const double norm = angle.norm();
    if (norm > 0) measures.angles[i] = angle / norm;
  }
}

// The mean over all frames: of lengths the arithmetic mean, which keeps the triangle inequality; of angles the circular
// mean (K. V. Mardia, P. E. Jupp, Directional Statistics, 2000, sect. 2.2). Complexity: O(F N).
template <class FT>
Edge_measures mean_edge_measures(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories,
                                 const Triangle_adjacency& adjacency)
{
  // Angles whose unit vectors cancel, as those of a hinge that is bent by 90 degrees to either side, have no circular
  // mean; the flat hinge is the middle between them.
  const double cancelled = 1e-6;
  const std::size_t m = shape.edges().size();
  Edge_measures mean, one;
  mean.lengths.assign(m, 0);
  mean.angles.assign(m, Eigen::Vector2d::Zero());
  std::vector<Eigen::Vector3d> normals;
  for (std::size_t f = 0; f < trajectories.number_of_frames(); ++f) {
    cancellation_point();
    const std::vector<Eigen::Vector3d> points = trajectories.frame(f).points();
    triangle_normals(shape, adjacency, points, normals);
    measure_edges(shape, adjacency, points, normals, one);
    for (std::size_t e = 0; e < m; ++e) {
      mean.lengths[e] += one.lengths[e];
      mean.angles[e] += one.angles[e];
    }
  }
  const double frames = double(trajectories.number_of_frames());
  for (std::size_t e = 0; e < m; ++e) {
    mean.lengths[e] /= frames;
    const double resultant = mean.angles[e].norm();
    if (resultant > cancelled * frames)
      mean.angles[e] /= resultant;
    else
      mean.angles[e] = Eigen::Vector2d::UnitX();
  }
  return mean;
}

// For each component the frame whose lengths and angles are closest to the mean, the first one of equals.
// Complexity: O(F N).
template <class FT>
std::vector<std::size_t> closest_frames(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories,
                                        const Triangle_adjacency& adjacency,
                                        const std::vector<Surface_component>& components, const Edge_measures& mean)
{
  std::vector<std::size_t> closest(components.size(), 0);
  std::vector<double> least(components.size(), (std::numeric_limits<double>::max)());
  std::vector<Eigen::Vector3d> normals;
  Edge_measures one;
  for (std::size_t f = 0; f < trajectories.number_of_frames(); ++f) {
    cancellation_point();
    const std::vector<Eigen::Vector3d> points = trajectories.frame(f).points();
    triangle_normals(shape, adjacency, points, normals);
    measure_edges(shape, adjacency, points, normals, one);
    for (std::size_t c = 0; c < components.size(); ++c) {
      double distance = 0;
      for (Rest_shape::Index e : components[c].edges) {
        const double l = mean.lengths[e], stretch = one.lengths[e] - l;
        distance += stretch * stretch;
        if (adjacency.is_interior(e)) distance += l * l * (one.angles[e] - mean.angles[e]).squaredNorm();
      }
      if (distance < least[c]) {
        least[c] = distance;
        closest[c] = f;
      }
    }
  }
  return closest;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_EDGE_MEASURES_H
