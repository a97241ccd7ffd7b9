// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The same features, bit for bit, from OpenMesh's two kinds of meshes, whose point map returns by value.

#include "test_support.h"

#ifndef ANIMATED_MESH_FEATURES_TEST_WITH_OPENMESH

int main()
{
  std::cout << "compiled without OpenMesh: skipped" << std::endl;
  return test_support::skipped;
}

#else

  #include <OpenMesh/Core/IO/MeshIO.hh>
  #include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
  #include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

  #include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
  #include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

  #include "test_same_features.h"

  #include <string>

using namespace test_support;

template <class Mesh>
void test_model(const Bumpy_sphere& sphere, const Model_test& test, const std::string& name)
{
  Mesh mesh;
  add_sphere(sphere, mesh);
  test(mesh, true, name);
}

// A mesh with elements that are deleted but not yet collected.
template <class Mesh>
void test_deleted(const Bumpy_sphere& sphere, const Model_test& test, const std::string& name)
{
  Bumpy_sphere other(2, 0);
  for (Point_3& p : other.rest) p = Point_3(p.x() + 5, p.y(), p.z());
  Mesh mesh;
  const auto unwanted = add_sphere(other, mesh);
  add_sphere(sphere, mesh);
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_face_status();
  for (auto v : unwanted) mesh.delete_vertex(v);
  CHECK(mesh.n_vertices() == unwanted.size() + sphere.rest.size());
  test(mesh, true, name + " with deleted elements");
}

template <class Mesh>
void test_mesh(const Bumpy_sphere& sphere, const Model_test& test, const std::string& name)
{
  test_model<Mesh>(sphere, test, name);
  test_deleted<Mesh>(sphere, test, name);
}

int main()
{
  const Bumpy_sphere sphere;
  const Model_test test(sphere);
  test_mesh<OpenMesh::PolyMesh_ArrayKernelT<>>(sphere, test, "OpenMesh::PolyMesh");
  test_mesh<OpenMesh::TriMesh_ArrayKernelT<>>(sphere, test, "OpenMesh::TriMesh");
  return test_result();
}

#endif
