// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The same features, bit for bit, from a Surface_mesh, however it holds the surface: faces in any order, removed elements
// that are not yet collected, or a part of a larger mesh. The other models have tests of their own, test_face_graph_*.cpp.

#include "test_same_features.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace test_support;
typedef CGAL::Surface_mesh<Point_3> Mesh;

// What is found is what was put in: a feature at each bump, at its time.
void test_reference(const Bumpy_sphere& sphere, const std::vector<Found>& features)
{
  CHECK(features.size() == sphere.bumps.size());
  for (const Bump& b : sphere.bumps) {
    bool met = false;
    for (const Found& f : features)
      met = met || (std::sqrt(CGAL::squared_distance(sphere.place(b), sphere.rest[f.vertex])) < b.width &&
                    std::abs(f.numbers[0] - b.time) < b.duration);
    CHECK(met);
  }
}

// The same triangles, shuffled, and each starting at another corner.
void test_order_of_faces(const Bumpy_sphere& sphere, const Model_test& test)
{
  Bumpy_sphere shuffled = sphere;
  std::mt19937 random(1);
  std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);
  for (auto& t : shuffled.triangles) std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  Mesh mesh;
  add_sphere(shuffled, mesh);
  test(mesh, true, "Surface_mesh, faces in another order");
}

// The sphere behind another one, in one mesh.
Mesh two_spheres(const Bumpy_sphere& sphere)
{
  Bumpy_sphere other(2, 0);
  for (Point_3& p : other.rest) p = Point_3(p.x() + 5, p.y(), p.z());
  Mesh mesh;
  add_sphere(other, mesh);
  add_sphere(sphere, mesh);
  return mesh;
}

bool belongs_to_other(const Mesh& mesh, Mesh::Vertex_index v)
{
  return mesh.point(v).x() > 3;
}

void test_removed(const Bumpy_sphere& sphere, const Model_test& test)
{
  Mesh mesh = two_spheres(sphere);
  for (Mesh::Face_index f : faces(mesh))
    if (belongs_to_other(mesh, target(halfedge(f, mesh), mesh))) mesh.remove_face(f);
  for (Mesh::Edge_index e : edges(mesh))
    if (belongs_to_other(mesh, mesh.vertex(e, 0))) mesh.remove_edge(e);
  for (Mesh::Vertex_index v : vertices(mesh))
    if (belongs_to_other(mesh, v)) mesh.remove_vertex(v);
  CHECK(mesh.has_garbage());
  CHECK(mesh.number_of_vertices() == sphere.rest.size());
  CHECK((*vertices(mesh).begin()).idx() > 0);
  test(mesh, true, "Surface_mesh with removed elements");

  // frames as property maps, which for Surface_mesh are ranges as well, but with an element for each removed vertex
  const std::vector<std::size_t> order = sphere_indices(sphere, mesh);
  std::vector<Mesh::Property_map<Mesh::Vertex_index, Point_3>> frames;
  for (std::size_t f = 0; f < sphere.frames.size(); ++f) {
    frames.push_back(mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:frame " + std::to_string(f)).first);
    std::size_t i = 0;
    for (Mesh::Vertex_index v : vertices(mesh)) frames.back()[v] = sphere.frames[f][order[i++]];
  }
  CGAL::Animated_mesh_features::Frame_sequence<Mesh> sequence(mesh, frames, sphere.frame_duration);
  sequence.set_rest_shape(mesh.points());
  check_same(test.features(), detect(sphere, sequence), 0, "Surface_mesh with removed elements, frames as property maps");
}

void test_filtered(const Bumpy_sphere& sphere, const Model_test& test)
{
  const Mesh mesh = two_spheres(sphere);
  std::vector<Mesh::Face_index> selected;
  for (Mesh::Face_index f : faces(mesh))
    if (!belongs_to_other(mesh, target(halfedge(f, mesh), mesh))) selected.push_back(f);
  const CGAL::Face_filtered_graph<Mesh> filtered(mesh, selected);
  test(filtered, true, "Face_filtered_graph");
}

// Coordinates and everything computed from them in single precision: the same vertices and frames; numbers differ by some
// 10^-7 of the coordinates, which the curvature of such coarse triangles and the second differences of the refinement
// amplify.
void test_float(const Bumpy_sphere& sphere, const Model_test& test)
{
  Mesh mesh;
  add_sphere(sphere, mesh);
  check_same(test.features(), detect(sphere, animated<float>(sphere, mesh)), 1e-5, "Frame_sequence of float");
}

int main()
{
  const Bumpy_sphere sphere;
  const Model_test test(sphere);
  test_reference(sphere, test.features());
  test_order_of_faces(sphere, test);
  test_removed(sphere, test);
  test_filtered(sphere, test);
  test_float(sphere, test);
  return test_result();
}
