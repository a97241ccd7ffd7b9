// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EVALUATE_FEATURES_RIG_H
#define EVALUATE_FEATURES_RIG_H

#include "evaluate_features/Feature_file.h"

#include <CGAL/Animated_mesh_features/Evaluation/Rig_events.h>
#include <CGAL/Animated_mesh_features/IO/Rig_file_data.h>

#include <string>
#include <vector>

namespace Evaluate_features {

// Where a skeleton's truth comes from: a file of events with the body at rest, or a clip of a model.
struct Rig_source
{
  std::string events, rest; // files, together
  std::string model, clip;  // a file, and the clip by name or number
  bool there_and_back = false;
};

// The truth about the animation on which features were found.
struct Rig
{
  CGAL::Animated_mesh_features::IO::Rig_file_data data;
  Points points; // of the vertices of which regions are made

  // for Rig_events
  std::vector<std::vector<CGAL::Animated_mesh_features::Rest_shape::Index>> regions() const;
  std::vector<CGAL::Animated_mesh_features::Joint_event> events() const;
};

// throws Input_error if the truth is about another animation than the features; Option_error if this program was built
// without what reads the model.
Rig read_rig(const Rig_source& source, const Feature_file& features);

// The truth of a clip of an animated model, sampled as the features' animation was.
// throws as `read_rig()` does.
Rig read_model_rig(const Rig_source& source, const Feature_file& features);

} // namespace Evaluate_features

#endif // EVALUATE_FEATURES_RIG_H
