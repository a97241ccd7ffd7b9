// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_ANIMATIONS_SETTINGS_H
#define COMPARE_ANIMATIONS_SETTINGS_H

#include "detect_features/Method_options.h"
#include "reading/Reading_options.h"
#include "running/Run_options.h"

#include <CGAL/Animated_mesh_features/Applications/Activity.h>
#include <CGAL/Animated_mesh_features/Applications/Alignment_options.h>
#include <CGAL/Animated_mesh_features/Applications/animation_distance.h>
#include <CGAL/Animated_mesh_features/Applications/event_differences.h>
#include <CGAL/Animated_mesh_features/Descriptors/Matching_options.h>

#include <string>
#include <vector>

namespace Compare_animations {

// All that can be told on the command line.
struct Settings
{
  std::vector<std::string> words; // what is no option
  bool help = false;
  Programs::Reading_options reading; // of all animations, but for their inputs
  Detect_features::Method_options method;
  Programs::Run_options run;

  CGAL::Animated_mesh_features::Activity_options activity;
  CGAL::Animated_mesh_features::Matching_options matching;
  CGAL::Animated_mesh_features::Alignment_options alignment;
  CGAL::Animated_mesh_features::Distance_options distance;
  CGAL::Animated_mesh_features::Event_gates gates;
  bool is_oriented = false; // the descriptor

  std::string cache;                         // folder; empty: none; "beside": next to each animation
  std::string json, plot, html, descriptors; // files; empty: none

  bool check = false;
  double tolerance = 0;
};

} // namespace Compare_animations

#endif // COMPARE_ANIMATIONS_SETTINGS_H
