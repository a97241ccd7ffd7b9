// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SIMPLIFY_ANIMATION_MEASUREMENT_H
#define SIMPLIFY_ANIMATION_MEASUREMENT_H

#include "reading/Sequence.h"
#include "running/Interruption.h"
#include "simplify_animation/Level_report.h"

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Applications/Simplified_animation.h>
#include <CGAL/Animated_mesh_features/Applications/simplification_errors.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>

#include <functional>
#include <vector>

namespace Simplify_animation {

// Measures how far levels are from the animation that they are of, which must live as long.
class Measurement
{
public:
  // With features, their regions are told from elsewhere. `before_level` is called before each level is measured; what it
  // throws ends the measurement.
  Measurement(const Programs::Sequence& sequence,
              const std::vector<CGAL::Animated_mesh_features::Feature_point>& features,
              std::function<void()> before_level = &Programs::Interruption::check);
  Measurement(const Measurement&) = delete;
  Measurement& operator=(const Measurement&) = delete;

  bool has_regions() const { return m_options.regions != nullptr; }

  Level_errors operator()(const CGAL::Animated_mesh_features::Animation_level& level) const;

private:
  const Programs::Sequence* m_sequence;
  std::function<void()> m_before_level;
  CGAL::Animated_mesh_features::Spatio_temporal_field<float> m_regions;
  CGAL::Animated_mesh_features::Simplification_error_options m_options;
};

// A report of all but the levels.
Level_report empty_report(const Programs::Sequence& sequence,
                          const CGAL::Animated_mesh_features::Simplified_animation& result);

} // namespace Simplify_animation

#endif // SIMPLIFY_ANIMATION_MEASUREMENT_H
