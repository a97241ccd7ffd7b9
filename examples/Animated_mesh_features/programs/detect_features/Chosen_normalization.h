// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_CHOSEN_NORMALIZATION_H
#define DETECT_FEATURES_CHOSEN_NORMALIZATION_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#include <CGAL/tags.h>

#include <vector>

namespace Detect_features {

namespace AMF = CGAL::Animated_mesh_features;

// A model of ScaleNormalization that is chosen when the program runs.
struct Chosen_normalization
{
  bool is_of_surface = true;

  std::vector<float>
  operator()(const AMF::Rest_shape& shape, const std::vector<double>& variances,
             const AMF::Task_loop<CGAL::Parallel_if_available_tag, AMF::Any_visitor>& loop) const;
};

} // namespace Detect_features

#endif // DETECT_FEATURES_CHOSEN_NORMALIZATION_H
