// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Simplification_data.h"

#include "running/Thread_limit.h"
#include "simplify_animation/Measurement.h"
#include "simplify_animation/simplify.h"
#include "simplify_animation/wanted_levels.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <utility>

namespace Python_module {

Simplification_data::Simplification_data(std::shared_ptr<const Animation_data> animation,
                                         const std::vector<AMF::Feature_point>& features, const Arguments& arguments,
                                         bool is_measured, Python_monitor& monitor)
  : m_animation(std::move(animation))
{
  const Options o = options_of(arguments, SIMPLIFICATION);
  const Programs::Thread_limit limit(o.run.threads);
  const Programs::Sequence& sequence = m_animation->sequence();
  AMF::Simplification_options method = simplification_options(o.simplification);
  method.vertices = wanted_levels(o.simplification, sequence.rest_shape());
  m_result =
      Simplify_animation::simplify(sequence, method, features, o.simplification.strength.value_or(0),
                                   [&](double fraction) { return monitor.progress("simplification", fraction); });
  m_report = Simplify_animation::empty_report(sequence, m_result);
  m_report.title =
      m_animation->reading().inputs.front() == "faces" ? "animation" : m_animation->reading().inputs.front();
  if (!is_measured && !o.simplification.error) return;
  std::size_t measured = 0;
  const Simplify_animation::Measurement measure(sequence, features, [&] {
    const double all = double(m_result.levels.size());
    if (!monitor.progress("errors", double(measured++) / all)) throw AMF::Cancelled();
  });
  m_report.has_regions = measure.has_regions();
  if (o.simplification.error) keep_coarsest_within(*o.simplification.error, m_report.diagonal, measure, m_result);
  for (const AMF::Animation_level& level : m_result.levels) m_report.levels.push_back(measure(level));
  if (!monitor.progress("errors", 1)) throw AMF::Cancelled();
}

std::vector<AMF::Rest_shape::Point> Simplification_data::points(std::size_t i) const
{
  return level(i).binding.positions(m_animation->shape().points());
}

} // namespace Python_module
