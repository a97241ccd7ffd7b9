// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "simplify_animation/Measurement.h"

#include <CGAL/Animated_mesh_features/Evaluation/feature_regions.h>

#include <utility>

namespace AMF = CGAL::Animated_mesh_features;

namespace Simplify_animation {

Measurement::Measurement(const Programs::Sequence& sequence, const std::vector<AMF::Feature_point>& features,
                         std::function<void()> before_level)
  : m_sequence(&sequence)
  , m_before_level(std::move(before_level))
{
  if (features.empty()) return;
  m_regions = AMF::feature_regions(sequence.rest_shape(), sequence.number_of_frames(), sequence.frame_duration(),
                                   features, AMF::Region_course::PRESENT);
  m_options.regions = &m_regions;
}

Level_errors Measurement::operator()(const AMF::Animation_level& level) const
{
  m_before_level();
  const auto coarse = [&](std::size_t f) { return level.binding.positions(m_sequence->trajectories().frame(f)); };
  AMF::Simplification_error_options options = m_options;
  options.vertex_of = &level.vertex_of;
  return {level.binding.size(), level.triangles.size(),
          AMF::simplification_errors(m_sequence->rest_shape(), m_sequence->trajectories(), level.triangles,
                                     level.binding.positions(m_sequence->rest_shape().points()), coarse, options)};
}

Level_report empty_report(const Programs::Sequence& sequence, const AMF::Simplified_animation& result)
{
  Level_report report;
  report.diagonal = sequence.rest_shape().bounding_box_diagonal();
  report.vertices = sequence.number_of_vertices();
  report.triangles = sequence.rest_shape().triangles().size();
  report.poses = result.poses;
  return report;
}

} // namespace Simplify_animation
