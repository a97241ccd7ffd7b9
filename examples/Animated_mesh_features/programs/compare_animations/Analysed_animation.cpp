// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compare_animations/Analysed_animation.h"

#include "detect_features/detect.h"
#include "options/Names.h"
#include "output/Pair_page.h"
#include "running/Monitor.h"

#include <CGAL/Animated_mesh_features/Animation/pose_variation.h>
#include <CGAL/Animated_mesh_features/Animation/vertex_areas.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>

#include <algorithm>

namespace AMF = CGAL::Animated_mesh_features;
using namespace Programs;

namespace Compare_animations {

namespace {

Memory_plan memory_plan(const Run_options& o)
{
  return Memory_plan(o.memory, o.scratch_directory.empty() ? default_scratch_directory() : o.scratch_directory);
}

} // namespace

Analysed_animation::Analysed_animation(const Item& item, const Settings& s)
  : m_name(item.name)
  , m_is_cyclic(item.reading.is_cyclic)
  , m_plan(memory_plan(s.run))
  , m_animation(item.reading,
                [&](std::size_t vertices, std::size_t frames) {
                  if (!s.html.empty()) check_pair_page(vertices, frames);
                  return m_plan.decide(vertices, frames, 1);
                })
  , m_files(m_outputs)
  , m_fields(m_outputs, m_files, m_log)
{
  m_plan.refine(m_animation.sequence().rest_shape());
  m_outputs.scenes.push_back({Scene_format::HTML, ""});
  Monitor monitor(m_log, false);
  Detect_features::Method_options method = s.method;
  method.is_cyclic = item.reading.is_cyclic;
  m_detection = Detect_features::detect(m_animation.sequence(), method, m_plan.level_memory(), m_fields, monitor);
}

AMF::Animation_signature Analysed_animation::signature(const Settings& s) const
{
  const std::vector<AMF::Feature_point> features(m_detection.features.begin(), m_detection.features.end());
  const Sequence& sequence = m_animation.sequence();
  AMF::Activity_options options = s.activity;
  options.is_cyclic = m_is_cyclic;
  const auto make = [&](const auto& descriptor) {
    AMF::Animation_signature result =
        AMF::animation_signature(sequence.rest_shape(), m_fields.kept().front().values, sequence.frame_duration(),
                                 features, options, descriptor);
    result.activity.pose_variation =
        AMF::pose_variation(sequence.trajectories(), AMF::vertex_areas(sequence.rest_shape()));
    return result;
  };
  return s.is_oriented ? make(AMF::Oriented_gradient_histogram()) : make(AMF::Rotation_free_gradient_histogram());
}

Shown_scene Analysed_animation::scene(std::size_t most)
{
  m_detection.features.resize((std::min)(most, m_detection.features.size()));
  Shown_scene result{m_animation.sequence(), m_detection.features, {}, m_name};
  result.is_cyclic = m_is_cyclic;
  for (const auto& f : m_fields.kept()) result.fields.push_back({name(f.kind), &f.values});
  return result;
}

} // namespace Compare_animations
