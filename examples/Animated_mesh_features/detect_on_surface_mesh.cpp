// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The shortest way: frames in, features out, with the default options.

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Animated_mesh_features::Frame_sequence<Mesh> Frame_sequence;
typedef CGAL::Animated_mesh_features::Spatio_temporal_feature<Mesh::Vertex_index> Feature;

int main()
{
  Animated_mesh_generators::Bending_cylinder_options options;
  options.vertices_around = 18;
  const auto cylinder = Animated_mesh_generators::bending_cylinder(options);

  //! [detect]
  // a mesh, the points of each frame in the order of its vertices, and the time between frames in seconds
  Frame_sequence animation(cylinder.mesh, cylinder.frames, cylinder.frame_duration);
  animation.set_rest_shape(cylinder.mesh.points());

  std::vector<Feature> features;
  CGAL::detect_spatio_temporal_features(animation, std::back_inserter(features));

  for (const Feature& f : features)
    std::cout << f.vertex << " at " << f.time << " s: height " << f.rest_position[2] << ", radius " << f.radius()
              << ", duration " << f.tau << " s, strength " << f.strength << std::endl;
  //! [detect]
  return features.empty() ? 1 : 0;
}
