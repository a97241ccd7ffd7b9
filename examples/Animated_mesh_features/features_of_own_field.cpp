// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Features of a scalar of your own, given for each vertex and frame of a mesh that need not move: here the temperature of a
// cylinder that a flame licks at for a moment.

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/rest_shape_of_mesh.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef AMF::Feature_detector<double> Detector;

const Point_3 flame(0.4, 0.1, 4.5);
const double size = 0.35, moment = 0.8, duration = 0.15;

double temperature(const Point_3& p, double time)
{
  const double late = time - moment;
  return 20 +
         80 * std::exp(-CGAL::squared_distance(p, flame) / (2 * size * size) - late * late / (2 * duration * duration));
}

int main()
{
  Animated_mesh_generators::Bending_cylinder_options options;
  options.vertices_around = 18;
  const Mesh mesh = Animated_mesh_generators::bending_cylinder(options).mesh;

  //! [field]
  const AMF::Rest_shape shape = AMF::rest_shape_of_mesh(mesh);
  const std::size_t number_of_frames = 60;
  const double frame_duration = 1. / 30; // seconds

  // a row for each vertex, in the order of vertices(mesh)
  Detector::Field field(shape.number_of_vertices(), number_of_frames);
  std::size_t row = 0;
  for (Mesh::Vertex_index v : vertices(mesh)) {
    for (std::size_t f = 0; f < number_of_frames; ++f)
      field(row, f) = temperature(mesh.point(v), double(f) * frame_duration);
    ++row;
  }

  Detector detector(shape, std::move(field), frame_duration);
  std::vector<Detector::Feature> features;
  detector(std::back_inserter(features));
  //! [field]
  for (const Detector::Feature& f : features)
    std::cout << "height " << f.rest_position[2] << " (flame: " << flame.z() << "), time " << f.time << " s (" << moment
              << "), sigma " << f.sigma << " (" << size << "), tau " << f.tau << " s (" << duration << ")" << std::endl;
  return features.empty() ? 1 : 0;
}
