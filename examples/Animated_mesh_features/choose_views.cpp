// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where to look at an animation from, so that its features are seen; and how a camera moves around it.

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Applications/camera_path.h>
#include <CGAL/Animated_mesh_features/Applications/select_views.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <cstddef>
#include <iostream>
#include <iterator>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Amf::Frame_sequence<Mesh> Frame_sequence;
typedef Amf::Spatio_temporal_feature<Mesh::Vertex_index> Feature;

int main()
{
  Animated_mesh_generators::Bending_cylinder_options cylinder_options;
  cylinder_options.vertices_around = 18;
  const auto cylinder = Animated_mesh_generators::bending_cylinder(cylinder_options);
  Frame_sequence animation(cylinder.mesh, cylinder.frames, cylinder.frame_duration);
  animation.set_rest_shape(cylinder.mesh.points());
  std::vector<Feature> features;
  CGAL::detect_spatio_temporal_features(animation, std::back_inserter(features));

  //! [views]
  Amf::View_options options;
  options.up = Eigen::Vector3d::UnitZ();
  options.lowest_elevation = 0; // not from below the ground
  const Amf::View_selection selection = Amf::select_views(animation, features, options);
  for (const Amf::Selected_view& view : selection.views)
    std::cout << "azimuth " << view.angles.azimuth << ", elevation " << view.angles.elevation << ": shows "
              << 100 * view.score << " % of the features, with those before " << 100 * view.covered << " %"
              << std::endl;
  //! [views]

  //! [path]
  // What each direction shows in the course of the clip, and the path of a camera that turns by at most 60 degrees a
  // second
  const std::size_t frames = animation.number_of_frames();
  const Amf::View_sphere sphere(2);
  const std::vector<std::size_t> looked_at = Amf::even_frames(frames, 24);
  const Amf::Feature_view_score score(animation.rest_shape(), looked_at, frames, animation.frame_duration(), features);
  const Amf::View_scores scores = Amf::score_views(animation, looked_at, sphere.directions(), score);
  Amf::Camera_path_options path_options;
  path_options.largest_speed = 60;
  const Amf::Camera_path path =
      Amf::camera_path(scores, sphere.longest_edge(), frames, animation.frame_duration(), path_options);
  std::cout << "the camera comes from " << path.direction(0).transpose() << " and shows " << 100 * path.score() << " %"
            << std::endl;
  //! [path]
  return selection.views.empty() ? 1 : 0;
}
