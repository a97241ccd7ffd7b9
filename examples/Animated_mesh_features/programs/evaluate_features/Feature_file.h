// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EVALUATE_FEATURES_FEATURE_FILE_H
#define EVALUATE_FEATURES_FEATURE_FILE_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/IO/Feature_file_data.h>
#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Evaluate_features {

typedef CGAL::Animated_mesh_features::Feature_point Feature_point;
typedef std::vector<CGAL::Animated_mesh_features::Rest_shape::Point> Points;

// A file of features, strongest first.
struct Feature_file
{
  std::string path;
  CGAL::Animated_mesh_features::IO::Feature_file_data data;

  // throws Input_error, also if a sigma or a tau is not positive.
  explicit Feature_file(const std::string& path);

  const std::vector<Feature_point>& features() const { return data.features; }
  double frame_duration() const { return data.description.frame_duration; }
  std::size_t frames() const { return data.description.frames; }
  double duration() const { return double(frames()) * frame_duration(); }
  bool is_cyclic() const; // whether the last frame of the animation is followed by the first
};

// The points of a mesh on which features were found: throws Input_error unless it has as many vertices.
Points read_points(const std::string& mesh, const Feature_file& features);

// The same for all of the shape.
CGAL::Animated_mesh_features::Rest_shape read_shape(const std::string& mesh, const Feature_file& features);

// of the axis-parallel bounding box of all points
double diagonal(const Points& points);

} // namespace Evaluate_features

#endif // EVALUATE_FEATURES_FEATURE_FILE_H
