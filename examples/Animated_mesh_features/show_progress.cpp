// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A visitor that shows how far a detection is, and cancels it after a while. What was measured by then is kept, so that the
// next attempt goes on from there.

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Animated_mesh_features/Deformation/subtract_baseline.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>
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

// A dot for each tenth of a stage.
struct Progress
{
  int patience; // calls
  int dots = 0;

  void begin(AMF::Stage stage)
  {
    std::cout << name(stage) << ' ' << std::flush;
    dots = 0;
  }
  bool progress(AMF::Stage, double fraction)
  {
    for (; dots < int(10 * fraction); ++dots) std::cout << '.' << std::flush;
    return --patience > 0; // a program with windows would look at its button here
  }
  void end(AMF::Stage) { std::cout << std::endl; }
};

int main()
{
  Animated_mesh_generators::Bending_cylinder_options options;
  options.vertices_around = 18;
  const auto cylinder = Animated_mesh_generators::bending_cylinder(options);
  const Frame_sequence animation(cylinder.mesh, cylinder.frames, cylinder.frame_duration);

  AMF::Deformation_measurement<Frame_sequence> measurement(animation);
  std::vector<Detector::Feature> features;
  for (int patience : {300, 10000}) {
    Progress progress = {patience};
    try {
      auto field = measurement.deformation(progress);
      AMF::subtract_baseline(field, AMF::Least_value_baseline());
      Detector detector(animation.rest_shape(), std::move(field), animation.frame_duration(),
                        AMF::Extremum_options<>(), measurement.noise());
      detector(std::back_inserter(features), progress);
    } catch (const AMF::Cancelled& e) {
      std::cout << e.what() << std::endl;
    }
  }
  std::cout << features.size() << " features" << std::endl;
  return features.empty() ? 1 : 0;
}
