// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The same motion on two meshes that have nothing to do with each other: which feature of one is which of the other.
// Features are described by the field around them and by their place on the body.

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Animated_mesh_features/Deformation/subtract_baseline.h>
#include <CGAL/Animated_mesh_features/Descriptors/match_features.h>
#include <CGAL/Animated_mesh_features/Detection/Detection_options.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <iterator>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
typedef Animated_mesh_generators::Generated_animation Generated_animation;
typedef AMF::Frame_sequence<Generated_animation::Mesh> Frame_sequence;
typedef AMF::Feature_detector<double, AMF::Calibrated_options::Search> Detector;

AMF::Described_features described(std::size_t vertices_around)
{
  Animated_mesh_generators::Bending_cylinder_options options;
  options.vertices_around = vertices_around;
  const Generated_animation cylinder = Animated_mesh_generators::bending_cylinder(options);
  Frame_sequence animation(cylinder.mesh, cylinder.frames, cylinder.frame_duration);
  animation.set_rest_shape(cylinder.mesh.points());
  const AMF::Rest_shape& shape = animation.rest_shape();

  AMF::Deformation_measurement<Frame_sequence> measurement(animation);
  Detector::Field field = measurement.take_deformation();
  AMF::subtract_baseline(field, AMF::Least_value_baseline());
  Detector detector(shape, field, animation.frame_duration());
  detector.selection() = AMF::Feature_selection();
  std::vector<Detector::Feature> found;
  detector(std::back_inserter(found));
  //! [describe]
  const std::vector<AMF::Feature_point> features(found.begin(), found.end());
  const AMF::Surface_landmarks landmarks(shape);
  return AMF::described_features(shape, landmarks, features,
                                 AMF::describe_features(shape, field, animation.frame_duration(), features));
  //! [describe]
}

int main()
{
  const AMF::Described_features a = described(18), b = described(24);
  //! [match]
  const std::vector<AMF::Feature_match> matches = AMF::match_features(a, b);
  for (const AMF::Feature_match& m : matches) {
    const AMF::Feature_point &f = a.features[m.a], &g = b.features[m.b];
    std::cout << "height " << f.rest_position[2] << " and " << g.rest_position[2] << ", time " << f.time << " s and "
              << g.time << " s, confidence " << m.confidence << std::endl;
  }
  //! [match]
  return matches.empty() ? 1 : 0;
}
