// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/Correspondence.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <fstream>
#include <limits>
#include <sstream>

namespace AMF = CGAL::Animated_mesh_features;
using Programs::Argument;
using Programs::Option_group;

namespace Evaluate_features {

namespace {

// One vertex of B for each vertex of A, a line each.
std::vector<std::size_t> read_map(const std::string& file, const Feature_file& a, const Feature_file& b)
{
  std::ifstream is(file);
  if (!is) throw AMF::Input_error(file + ": cannot read");
  std::vector<std::size_t> map;
  std::string line;
  while (std::getline(is, line)) {
    std::istringstream words(line);
    unsigned long long vertex = 0;
    std::string rest;
    const bool is_number = bool(words >> vertex) && line.find('-') == std::string::npos && !(words >> rest);
    if (!is_number || vertex >= b.data.description.vertices)
      throw AMF::Input_error(file + ": line " + std::to_string(map.size() + 1) + ": \"" + line +
                             "\" is no vertex of the " + std::to_string(b.data.description.vertices) + " of " + b.path);
    map.push_back(std::size_t(vertex));
  }
  if (map.size() != a.data.description.vertices)
    throw AMF::Input_error(file + ": has " + std::to_string(map.size()) + " lines; " + a.path + " is about " +
                           std::to_string(a.data.description.vertices) + " vertices, which need one each");
  return map;
}

// By looking at all points: a few features are asked for, not all vertices.
std::size_t nearest(const AMF::Rest_shape::Point& p, const Points& points)
{
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double d = (points[i] - p).squaredNorm();
    if (!(d < least)) continue;
    least = d;
    best = i;
  }
  return best;
}

} // namespace

void Pair_options::check(const std::string& command) const
{
  if (files.size() != 2) throw AMF::Option_error(command + " compares two files of features");
}

std::vector<std::string> Pair_options::paths() const
{
  std::vector<std::string> all = files;
  for (const std::string& path : {rest_a, rest_b})
    if (!path.empty()) all.push_back(path);
  if (!map.empty() && map != "same" && map != "nearest") all.push_back(map);
  return all;
}

void add_pair_options(Programs::Option_groups& groups, Pair_options& o)
{
  Option_group& group = groups.add_group("Meshes");
  group.add("rest-a", "MESH", "the rest shape on which the features of A were found",
            [&](const Argument& a) { o.rest_a = a.text(); });
  group.add("rest-b", "MESH", "that of B", [&](const Argument& a) { o.rest_b = a.text(); });
  group.add(
      "map", "FILE",
      "which vertex of B corresponds to each vertex of A: a file with a number in each line, from 0; same, if they "
      "have the same numbers; nearest, if the rest shapes lie in the same place (default)",
      [&](const Argument& a) { o.map = a.text(); });
}

std::vector<std::size_t> corresponding_vertices(const Pair_options& options, const Feature_file& a,
                                                const Feature_file& b, const Points& points_of_b)
{
  std::vector<std::size_t> result;
  if (options.map.empty() || options.map == "nearest") {
    if (options.rest_a.empty())
      throw AMF::Option_error("the nearest vertices are found with --rest-a only; or see --map");
    const Points points_of_a = read_points(options.rest_a, a);
    for (const Feature_point& f : a.features()) result.push_back(nearest(points_of_a[f.vertex_index], points_of_b));
  } else if (options.map == "same") {
    if (a.data.description.vertices != b.data.description.vertices)
      throw AMF::Input_error(a.path + " is about " + std::to_string(a.data.description.vertices) + " vertices, " +
                             b.path + " about " + std::to_string(b.data.description.vertices) +
                             ": they are not the same");
    for (const Feature_point& f : a.features()) result.push_back(f.vertex_index);
  } else {
    const std::vector<std::size_t> map = read_map(options.map, a, b);
    for (const Feature_point& f : a.features()) result.push_back(map[f.vertex_index]);
  }
  return result;
}

} // namespace Evaluate_features
