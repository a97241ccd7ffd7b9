// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A detector keeps what it has computed: asking again with other thresholds costs next to nothing.

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef CGAL::Animated_mesh_features::Frame_sequence<Mesh> Frame_sequence;
typedef CGAL::Animated_mesh_features::Feature_detector<Frame_sequence> Detector;

int main()
{
  Animated_mesh_generators::Bending_cylinder_options options;
  options.vertices_around = 18;
  const auto cylinder = Animated_mesh_generators::bending_cylinder(options);
  const Frame_sequence animation(cylinder.mesh, cylinder.frames, cylinder.frame_duration);

  Detector detector(animation);
  for (double threshold : {0.2, 0.5, 0.8, 0.01}) {
    detector.selection().relative_threshold = threshold;
    std::vector<Detector::Feature> features;
    CGAL::Real_timer timer;
    timer.start();
    detector(std::back_inserter(features));
    std::cout << features.size() << " of " << detector.number_of_minima() << " minima have " << threshold
              << " of the largest strength (" << timer.time() << " s)" << std::endl;
  }
  return 0;
}
