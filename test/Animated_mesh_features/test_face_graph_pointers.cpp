// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The same features from meshes whose descriptors are no indices: Polyhedron_3 with and without ids, and
// Linear_cell_complex.

#include "test_same_features.h"

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <string>

using namespace test_support;
typedef CGAL::Simple_cartesian<double> Kernel;

template <class Mesh>
void test_model(const Bumpy_sphere& sphere, const Model_test& test, const std::string& name)
{
  Mesh mesh;
  add_sphere(sphere, mesh);
  test(mesh, true, name);

  // copied face by face, which brings the vertices into the order in which faces meet them
  CGAL::Surface_mesh<Point_3> surface_mesh;
  add_sphere(sphere, surface_mesh);
  Mesh copy;
  CGAL::copy_face_graph(surface_mesh, copy);
  test(copy, false, name + ", vertices in another order");
}

int main()
{
  const Bumpy_sphere sphere;
  const Model_test test(sphere);
  test_model<CGAL::Polyhedron_3<Kernel>>(sphere, test, "Polyhedron_3");
  test_model<CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>>(sphere, test, "Polyhedron_3 with ids");
  typedef CGAL::Linear_cell_complex_traits<3, Kernel> Traits;
  typedef CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Traits>::type Linear_cell_complex;
  test_model<Linear_cell_complex>(sphere, test, "Linear_cell_complex");
  return test_result();
}
