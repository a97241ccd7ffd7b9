// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SIMPLIFY_ANIMATION_LEVEL_REPORT_H
#define SIMPLIFY_ANIMATION_LEVEL_REPORT_H

#include "plots/write_curves.h"

#include <CGAL/Animated_mesh_features/Applications/simplification_errors.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace Simplify_animation {

// A level and its errors, frame by frame.
struct Level_errors
{
  std::size_t vertices, triangles;
  std::vector<CGAL::Animated_mesh_features::Simplification_error> frames;
};

// All lengths in % of the diagonal.
struct Level_report
{
  std::string title;
  double diagonal;
  std::size_t vertices, triangles; // of the original
  std::vector<std::size_t> poses;
  bool has_regions = false;
  std::vector<Level_errors> levels;
};

std::string text_of(const Level_report& report);
nlohmann::ordered_json json_of(const Level_report& report);
Programs::Curves curves_of(const Level_report& report);

} // namespace Simplify_animation

#endif // SIMPLIFY_ANIMATION_LEVEL_REPORT_H
