// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_CLIP_TABLE_H
#define DETECT_FEATURES_CLIP_TABLE_H

#include "reading/Sequence.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace Detect_features {

// What was found in an animation, in short.
struct Outcome
{
  std::size_t frames = 0;
  double duration = 0; // seconds
  std::size_t features = 0;
  std::optional<Programs::Feature> strongest;
  std::string reason; // why there are no features
};

// Of a clip among several.
struct Clip_outcome
{
  std::string clip;
  Outcome outcome;
  std::string failure; // why it was left out; empty if it was not
};

// A line for each clip.
std::string clip_table(const std::vector<Clip_outcome>& clips);

} // namespace Detect_features

#endif // DETECT_FEATURES_CLIP_TABLE_H
