// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "simplify_animation/simplify.h"

#include <CGAL/Animated_mesh_features/Applications/simplify_animation.h>

#include <optional>

namespace AMF = CGAL::Animated_mesh_features;

namespace Simplify_animation {

AMF::Simplified_animation simplify(const Programs::Sequence& sequence, const AMF::Simplification_options& options,
                                   const std::vector<AMF::Feature_point>& features, double strength,
                                   const std::function<bool(double)>& watch)
{
  std::optional<AMF::Feature_guidance> guidance;
  if (strength > 0)
    guidance.emplace(sequence.rest_shape(), sequence.number_of_frames(), sequence.frame_duration(), features, strength);
  const auto weight = [&](std::size_t v, std::size_t f) { return guidance ? (*guidance)(v, f) : 1.; };
  return AMF::simplify_animation(sequence, options, weight, watch);
}

} // namespace Simplify_animation
