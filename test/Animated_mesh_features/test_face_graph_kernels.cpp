// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The same features, bit for bit, whatever the kernel of the points.

#include "test_same_features.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <string>

using namespace test_support;

template <class Kernel>
void test_kernel(const Bumpy_sphere& sphere, const std::vector<Found>& expected, const std::string& name)
{
  typedef typename Kernel::Point_3 Point;
  CGAL::Surface_mesh<Point> mesh;
  add_sphere(sphere, mesh);
  check_same(expected, detect(sphere, animated<double, Point>(sphere, mesh)), 0, name);
}

// Coordinates of exact numbers that no double represents are rounded, once.
void test_exact_coordinates(const Bumpy_sphere& sphere)
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  Mesh mesh;
  add_sphere(sphere, mesh);
  const Kernel::FT third = Kernel::FT(1) / 3;
  std::vector<std::vector<Kernel::Point_3>> frames(3);
  for (auto& frame : frames)
    for (auto v : vertices(mesh)) frame.push_back(Kernel::Point_3(third, third * mesh.point(v).y(), mesh.point(v).z()));
  const CGAL::Animated_mesh_features::Frame_sequence<Mesh> sequence(mesh, frames, 1);
  for (auto v : vertices(mesh)) {
    const auto p = get(sequence.point_map(2), v);
    CHECK_NEAR(p.x(), 1. / 3, 1e-16);
    CHECK_NEAR(p.y(), sphere.rest[v.idx()].y() / 3, 1e-15);
    CHECK(p.z() == sphere.rest[v.idx()].z());
  }
}

int main()
{
  const Bumpy_sphere sphere;
  CGAL::Surface_mesh<Point_3> mesh;
  add_sphere(sphere, mesh);
  const std::vector<Found> expected = detect(sphere, animated(sphere, mesh));
  test_kernel<CGAL::Simple_cartesian<double>>(sphere, expected, "Simple_cartesian<double>");
  test_kernel<CGAL::Simple_cartesian<float>>(sphere, expected, "Simple_cartesian<float>");
  test_kernel<CGAL::Exact_predicates_inexact_constructions_kernel>(sphere, expected, "EPICK");
  test_kernel<CGAL::Exact_predicates_exact_constructions_kernel>(sphere, expected, "EPECK");
  test_exact_coordinates(sphere);
  return test_result();
}
