// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Features of a scalar of your own, given for each vertex and frame, in place of the deformation: here the temperature of
// a cylinder that a flame licks at for a moment.

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Animated_mesh_features::Frame_sequence<Mesh> Frame_sequence;
typedef CGAL::Animated_mesh_features::Feature_detector<Frame_sequence> Detector;

int main()
{
  Animated_mesh_generators::Bending_cylinder_options options;
  options.vertices_around = 18;
  const auto cylinder = Animated_mesh_generators::bending_cylinder(options);
  const Frame_sequence animation(cylinder.mesh, cylinder.frames, cylinder.frame_duration);

  const Point_3 flame(0.4, 0.1, 4.5);
  const double size = 0.35, time = 0.8, duration = 0.15;
  Detector::Field temperature(animation.number_of_vertices(), animation.number_of_frames());
  for (std::size_t i = 0; i < temperature.number_of_rows(); ++i) {
    const Point_3& p = cylinder.mesh.point(animation.vertex_descriptors()[i]);
    for (std::size_t f = 0; f < temperature.number_of_frames(); ++f) {
      const double late = double(f) * animation.frame_duration() - time;
      temperature(i, f) = 20 + 80 * std::exp(-CGAL::squared_distance(p, flame) / (2 * size * size) -
                                             late * late / (2 * duration * duration));
    }
  }

  //! [field]
  Detector detector(animation);
  detector.set_deformation(temperature);
  std::vector<Detector::Feature> features;
  detector(std::back_inserter(features));
  //! [field]
  for (const Detector::Feature& f : features)
    std::cout << "height " << f.rest_position[2] << " (flame: " << flame.z() << "), time " << f.time << " s (" << time
              << "), sigma " << f.sigma << " (" << size << "), tau " << f.tau << " s (" << duration << ")" << std::endl;
  return features.empty() ? 1 : 0;
}
