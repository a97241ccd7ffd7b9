// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EVALUATE_FEATURES_CORRESPONDENCE_H
#define EVALUATE_FEATURES_CORRESPONDENCE_H

#include "evaluate_features/Feature_file.h"
#include "options/Option_groups.h"

#include <cstddef>
#include <string>
#include <vector>

namespace Evaluate_features {

// Two files of features, and what their meshes have to do with one another.
struct Pair_options
{
  std::vector<std::string> files; // A and B
  std::string map;                // a file, "same" or "nearest"; empty: nearest
  std::string rest_a, rest_b;     // meshes; empty: none

  // throws Option_error unless there are two files.
  void check(const std::string& command) const;

  // all files that are named
  std::vector<std::string> paths() const;
};

void add_pair_options(Programs::Option_groups& groups, Pair_options& options);

// The vertex of B that corresponds to the vertex of each feature of A.
// `points_of_b` are used for the nearest one only.
// throws Option_error if the options do not tell; Input_error if a file is no map from A to B, with the line.
std::vector<std::size_t> corresponding_vertices(const Pair_options& options, const Feature_file& a,
                                                const Feature_file& b, const Points& points_of_b);

} // namespace Evaluate_features

#endif // EVALUATE_FEATURES_CORRESPONDENCE_H
