// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_ANIMATIONS_OUTPUT_H
#define COMPARE_ANIMATIONS_OUTPUT_H

#include "compare_animations/Distance_matrix.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace Compare_animations {

typedef nlohmann::ordered_json Json;

// What a command has found.
struct Result
{
  std::string text;                      // a table, for people
  Json json = Json::object();            // the same for programs
  std::optional<Distance_matrix> matrix; // what --plot draws
  std::string page;                      // what --html writes
  std::size_t broken = 0;                // how many animations were left out
  std::string failure;                   // of a check: what exceeds the tolerance
};

} // namespace Compare_animations

#endif // COMPARE_ANIMATIONS_OUTPUT_H
