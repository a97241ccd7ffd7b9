// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

#ifndef CGAL_EIGEN3_ENABLED
  #error "CGAL is not told of Eigen"
#endif

// Whether instances are declared and not made: without the library they would not link.
#if defined(EXPECT_COMPILED) != defined(CGAL_ANIMATED_MESH_FEATURES_COMPILED)
  #error "the compiled library is used where it should not be, or not used where it should"
#endif

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Animated_mesh_features::Frame_sequence<Mesh> Frame_sequence;
typedef CGAL::Animated_mesh_features::Spatio_temporal_feature<Mesh::Vertex_index> Feature;

// in the other translation unit, which includes the same headers: a function that is not inline would not link
double largest_strength(const std::vector<Feature>& features);

int main()
{
#ifdef CGAL_LINKED_WITH_TBB
  const bool with_tbb = true;
#else
  const bool with_tbb = false;
#endif
  if (with_tbb != bool(EXPECT_TBB)) {
    std::cerr << "with TBB: " << with_tbb << ", expected: " << EXPECT_TBB << std::endl;
    return EXIT_FAILURE;
  }

  // A square plate, 25 x 25 vertices at distance 1, in whose middle a bump rises and sinks again.
  const int n = 25, number_of_frames = 41;
  Mesh mesh;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) mesh.add_vertex(Kernel::Point_3(i, j, 0));
  typedef Mesh::Vertex_index V;
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const int v = j * n + i;
      mesh.add_face(V(v), V(v + 1), V(v + n + 1));
      mesh.add_face(V(v), V(v + n + 1), V(v + n));
    }
  std::vector<std::vector<Kernel::Point_3>> frames(number_of_frames);
  for (int f = 0; f < number_of_frames; ++f)
    for (V v : mesh.vertices()) {
      const double x = mesh.point(v).x(), y = mesh.point(v).y(), t = (f - 20) / 4.;
      const double square = (x - 12) * (x - 12) + (y - 12) * (y - 12);
      frames[f].push_back(Kernel::Point_3(x, y, 2 * std::exp(-square / 8 - t * t / 2)));
    }

  Frame_sequence animation(mesh, frames, 1. / 25);
  animation.set_rest_shape(mesh.points());
  std::vector<Feature> features;
  CGAL::detect_spatio_temporal_features(animation, std::back_inserter(features));

  if (features.empty() || largest_strength(features) != features.front().strength) {
    std::cerr << "no features, or not the strongest first" << std::endl;
    return EXIT_FAILURE;
  }
  const Feature& f = features.front();
  const double distance = std::hypot(f.rest_position[0] - 12, f.rest_position[1] - 12);
  std::cout << features.size() << " features, the strongest at " << f.time << " s, " << distance
            << " from the middle\n";
  if (!(distance < 5 && std::abs(f.time - 20. / 25) < 0.1)) {
    std::cerr << "the bump is elsewhere" << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
