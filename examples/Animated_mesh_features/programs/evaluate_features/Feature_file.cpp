// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/Feature_file.h"

#include <CGAL/Animated_mesh_features/Animation/rest_shape_of_mesh.h>
#include <CGAL/Animated_mesh_features/IO/read_json.h>
#include <CGAL/Animated_mesh_features/IO/read_mesh.h>
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <numeric>
#include <variant>

namespace AMF = CGAL::Animated_mesh_features;

namespace Evaluate_features {

namespace {

// Strongest first, in the order of the file among equals; what is known of the vertices goes with the features.
void sort_by_strength(AMF::IO::Feature_file_data& data)
{
  std::vector<std::size_t> order(data.features.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return data.features[a].strength > data.features[b].strength;
  });
  std::vector<Feature_point> features;
  std::vector<std::vector<std::size_t>> file_vertices;
  for (std::size_t i : order) {
    features.push_back(data.features[i]);
    if (!data.file_vertices.empty()) file_vertices.push_back(data.file_vertices[i]);
  }
  data.features.swap(features);
  data.file_vertices.swap(file_vertices);
}

AMF::IO::Indexed_mesh read_mesh_of(const std::string& file, const Feature_file& features)
{
  AMF::IO::Mesh_reading_options options;
  options.triangulate_faces = true; // their vertices stay what they are
  AMF::IO::Indexed_mesh mesh = AMF::IO::read_mesh(file, options);
  if (mesh.points.size() != features.data.description.vertices)
    throw AMF::Input_error(file + ": has " + std::to_string(mesh.points.size()) + " vertices, the features of " +
                           features.path + " were found on " + std::to_string(features.data.description.vertices));
  return mesh;
}

} // namespace

Feature_file::Feature_file(const std::string& path)
  : path(path)
  , data(AMF::IO::read_json(path))
{
  for (std::size_t i = 0; i < data.features.size(); ++i)
    if (!(data.features[i].sigma > 0) || !(data.features[i].tau > 0))
      throw AMF::Input_error(path + ": features[" + std::to_string(i) + "]: sigma and tau must be positive");
  sort_by_strength(data);
}

bool Feature_file::is_cyclic() const
{
  for (const auto& [name, value] : data.description.parameters)
    if (name == "cyclic") return std::get_if<bool>(&value) != nullptr && std::get<bool>(value);
  return false;
}

Points read_points(const std::string& file, const Feature_file& features)
{
  Points points;
  for (const auto& p : read_mesh_of(file, features).points) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

AMF::Rest_shape read_shape(const std::string& file, const Feature_file& features)
{
  return AMF::rest_shape_of_mesh(AMF::IO::to_surface_mesh(read_mesh_of(file, features), file));
}

double diagonal(const Points& points)
{
  AMF::Rest_shape::Point low = points.front(), high = low;
  for (const AMF::Rest_shape::Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

} // namespace Evaluate_features
