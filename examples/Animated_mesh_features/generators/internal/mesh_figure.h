// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_INTERNAL_MESH_FIGURE_H
#define ANIMATED_MESH_GENERATORS_INTERNAL_MESH_FIGURE_H

#include "../Generated_animation.h"
#include "Figure_body.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/facets_in_complex_3_to_triangle_mesh.h>
#include <CGAL/make_mesh_3.h>

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

// Delaunay refinement, as coarse as the thinnest parts allow: it settles the topology. It places its points by a
// random generator with a fixed seed.
inline Figure_mesh coarse_figure(const Figure_body& body)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Labeled_mesh_domain_3<Kernel> Domain;
  typedef CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
  typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> Complex;
  typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;

  const auto value = [&body](const Kernel::Point_3& p) { return body.value(Eigen::Vector3d(p.x(), p.y(), p.z())); };
  // Around the whole figure, with its centre inside: from there the first points are sought.
  const Kernel::Sphere_3 sphere(Kernel::Point_3(0, 0, 0.9), 4);
  Domain domain = Domain::create_implicit_mesh_domain(value, sphere);
  const Criteria criteria(Criteria::Facet_criteria(25, 0.05, 0.005), Criteria::Cell_criteria(0, 0));
  const Complex complex = CGAL::make_mesh_3<Complex>(domain, criteria, CGAL::parameters::no_perturb(),
                                                     CGAL::parameters::no_exude(), CGAL::parameters::manifold());
  Figure_mesh mesh;
  CGAL::facets_in_complex_3_to_triangle_mesh(complex, mesh);
  return mesh;
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
