// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A detector keeps what it has found: asking again with other thresholds costs next to nothing. Whoever wants that puts the
// two stages of a detection together: the measurement makes a field of the animation, the detector finds features in it.

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Animated_mesh_features/Deformation/subtract_baseline.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef AMF::Frame_sequence<Mesh> Frame_sequence;
typedef AMF::Feature_detector<double> Detector;

int main()
{
  Animated_mesh_generators::Bending_cylinder_options cylinder_options;
  cylinder_options.vertices_around = 18;
  const auto cylinder = Animated_mesh_generators::bending_cylinder(cylinder_options);
  const Frame_sequence animation(cylinder.mesh, cylinder.frames, cylinder.frame_duration);

  //! [stages]
  AMF::Deformation_measurement<Frame_sequence> measurement(animation);
  auto field = measurement.take_deformation();
  AMF::subtract_baseline(field, AMF::Least_value_baseline());
  Detector detector(animation.rest_shape(), std::move(field), animation.frame_duration(), AMF::Extremum_options<>(),
                    measurement.noise());
  detector.selection() = AMF::Feature_selection();

  for (double threshold : {0.125, 0.3, 0.5, 0.01}) {
    detector.selection().absolute_threshold = threshold;
    std::vector<Detector::Feature> features;
    CGAL::Real_timer timer;
    timer.start();
    detector(std::back_inserter(features));
    std::cout << features.size() << " of " << detector.number_of_minima() << " minima have " << threshold
              << " of the largest strength (" << timer.time() << " s)" << std::endl;
  }
  //! [stages]
  return 0;
}
