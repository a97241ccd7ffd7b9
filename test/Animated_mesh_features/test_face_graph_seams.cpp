// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Seam_mesh: without a seam the same features; along a seam vertices are doubled and the surface has a border, which far from
// it changes little.

#include "test_same_features.h"

#include <CGAL/Animated_mesh_features/Deformation/strain.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace test_support;
namespace AMF = CGAL::Animated_mesh_features;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Seam_edges;
typedef Mesh::Property_map<Mesh::Vertex_index, bool> Seam_vertices;
typedef CGAL::Seam_mesh<Mesh, Seam_edges, Seam_vertices> Seam_mesh;

Mesh::Vertex_index nearest_vertex(const Mesh& mesh, const Point_3& p)
{
  const auto nearer = [&](Mesh::Vertex_index a, Mesh::Vertex_index b) {
    return CGAL::squared_distance(mesh.point(a), p) < CGAL::squared_distance(mesh.point(b), p);
  };
  return *std::min_element(vertices(mesh).begin(), vertices(mesh).end(), nearer);
}

// A path across the side of the sphere that has no bump: always on to the neighbour that is nearest to the end.
std::vector<Mesh::Vertex_index> path(const Mesh& mesh)
{
  const Mesh::Vertex_index end = nearest_vertex(mesh, Point_3(-0.3, -0.8, 0.5));
  std::vector<Mesh::Vertex_index> result(1, nearest_vertex(mesh, Point_3(0.3, -0.9, -0.3)));
  while (result.back() != end) {
    Mesh::Vertex_index next = result.back();
    for (Mesh::Vertex_index v : vertices_around_target(halfedge(result.back(), mesh), mesh))
      if (CGAL::squared_distance(mesh.point(v), mesh.point(end)) <
          CGAL::squared_distance(mesh.point(next), mesh.point(end)))
        next = v;
    result.push_back(next);
  }
  return result;
}

void test_real_seam(const Bumpy_sphere& sphere, const Mesh& mesh, Seam_mesh& seam_mesh,
                    const std::vector<Found>& expected)
{
  const std::vector<Mesh::Vertex_index> seam = path(mesh);
  CHECK(seam.size() >= 5);
  for (std::size_t i = 0; i + 1 < seam.size(); ++i) CHECK(seam_mesh.add_seam(seam[i], seam[i + 1]));

  const auto sequence = animated(sphere, seam_mesh);
  // all but the two ends are doubled, and each edge has become two border edges
  CHECK(sequence.number_of_vertices() == sphere.rest.size() + seam.size() - 2);
  const AMF::Animation_report report = sequence.report();
  CHECK(report.border_edges == 2 * (seam.size() - 1));
  CHECK(report.connected_components == 1 && report.isolated_vertices == 0 && report.degenerate_rest_triangles == 0);

  // the strain of a vertex is that of its triangles, of which only those at the seam have lost some
  const std::vector<std::size_t> order = sphere_indices(sphere, seam_mesh);
  const auto plain = animated(sphere, mesh);
  const AMF::Spatio_temporal_field<double> a = AMF::strain(plain), b = AMF::strain(sequence);
  double largest = 0;
  std::size_t compared = 0;
  for (std::size_t v = 0; v < order.size(); ++v) {
    if (sequence.rest_shape().is_border(v)) continue;
    ++compared;
    for (std::size_t f = 0; f < a.number_of_frames(); ++f)
      largest = (std::max)(largest, std::abs(a(order[v], f) - b(v, f)));
  }
  CHECK(compared == sphere.rest.size() - seam.size());
  CHECK_NEAR(largest, 0, 1e-12);

  // the bumps are more than five times their width away, the widest smoothing still reaches
  check_same(expected, detect(sphere, sequence), 1e-2, "Seam_mesh with a seam");
}

int main()
{
  const Bumpy_sphere sphere;
  Mesh mesh;
  add_sphere(sphere, mesh);
  Seam_edges seam_edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:on_seam", false).first;
  Seam_vertices seam_vertices = mesh.add_property_map<Mesh::Vertex_index, bool>("v:on_seam", false).first;
  Seam_mesh seam_mesh(mesh, seam_edges, seam_vertices);
  const Model_test test(sphere);
  test(seam_mesh, false, "Seam_mesh without seams");
  test_real_seam(sphere, mesh, seam_mesh, test.features());
  return test_result();
}
