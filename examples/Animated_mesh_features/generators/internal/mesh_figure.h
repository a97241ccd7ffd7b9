// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_INTERNAL_MESH_FIGURE_H
#define ANIMATED_MESH_GENERATORS_INTERNAL_MESH_FIGURE_H

#include "../Generated_animation.h"
#include "Figure_body.h"
#include "Marching_tetrahedra.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Animated_mesh_generators {
namespace internal {

typedef Generated_animation::Mesh Figure_mesh;

inline Eigen::Vector3d to_vector(const Generated_animation::Kernel::Point_3& p)
{
  return Eigen::Vector3d(p.x(), p.y(), p.z());
}

inline Generated_animation::Kernel::Point_3 to_point(const Eigen::Vector3d& p)
{
  return Generated_animation::Kernel::Point_3(p.x(), p.y(), p.z());
}

// Settles the topology: fine enough for creases of radius 0.03.
inline Figure_mesh coarse_figure(const Figure_body& body)
{
  const auto value = [&body](const Eigen::Vector3d& p) { return body.value(p); };
  const Marching_tetrahedra<decltype(value)> surface(value, Eigen::Vector3d(-1.05, -0.75, -0.05), {95, 95, 141}, 0.016);
  return surface.mesh();
}

// Newton steps along the gradient; the value is nearly a distance, so that few suffice.
inline void project_to_surface(const Figure_body& body, Figure_mesh& mesh)
{
  const int steps = 3;
  for (const auto v : vertices(mesh)) {
    Eigen::Vector3d p = to_vector(mesh.point(v));
    for (int i = 0; i < steps; ++i) {
      const Eigen::Vector3d g = body.gradient(p);
      p -= body.value(p) / g.squaredNorm() * g;
    }
    mesh.point(v) = to_point(p);
  }
}

// Moves vertices along the surface to the mean of their neighbours.
inline void even_out(const Figure_body& body, Figure_mesh& mesh)
{
  std::vector<Eigen::Vector3d> moved;
  for (const auto v : vertices(mesh)) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    std::size_t n = 0;
    for (const auto w : vertices_around_target(halfedge(v, mesh), mesh)) {
      mean += to_vector(mesh.point(w));
      ++n;
    }
    const Eigen::Vector3d p = to_vector(mesh.point(v)), normal = body.gradient(p).normalized();
    const Eigen::Vector3d step = mean / double(n) - p;
    moved.push_back(p + step - step.dot(normal) * normal);
  }
  std::size_t i = 0;
  for (const auto v : vertices(mesh)) mesh.point(v) = to_point(moved[i++]);
  project_to_surface(body, mesh);
}

/// The figure's surface in about `number_of_vertices` vertices, in triangles of nearly one size.
inline Figure_mesh mesh_figure(const Figure_body& body, std::size_t number_of_vertices)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Figure_mesh mesh = coarse_figure(body);
  // A closed mesh has about twice as many triangles as vertices, each, if equilateral, of area sqrt(3)/4 edge^2.
  const double mean_edge = std::sqrt(2 / std::sqrt(3.) * PMP::area(mesh) / double(number_of_vertices));
  // The remesher splits at 4/3 and collapses at 4/5 of the length it is told, and ends with edges that are shorter by
  // this factor, measured for 1000 to 30000 vertices.
  const double edge = mean_edge / 0.928;
  PMP::isotropic_remeshing(faces(mesh), edge, mesh, CGAL::parameters::number_of_iterations(5));
  project_to_surface(body, mesh);
  for (int i = 0; i < 5; ++i) even_out(body, mesh);
  mesh.collect_garbage();
  return mesh;
}

} // namespace internal
} // namespace Animated_mesh_generators

#endif // ANIMATED_MESH_GENERATORS_INTERNAL_MESH_FIGURE_H
