// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_MODULE_SIMPLIFICATION_DATA_H
#define PYTHON_MODULE_SIMPLIFICATION_DATA_H

#include "Animation_data.h"
#include "Arguments.h"
#include "Python_monitor.h"
#include "simplify_animation/Level_report.h"

#include <CGAL/Animated_mesh_features/Applications/Simplified_animation.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>

#include <memory>
#include <string>
#include <vector>

namespace Python_module {

// What simplify_animation makes of an animation.
class Simplification_data
{
public:
  // `is_measured` tells whether there is a report of all levels.
  Simplification_data(std::shared_ptr<const Animation_data> animation, const std::vector<AMF::Feature_point>& features,
                      const Arguments& arguments, bool is_measured, Python_monitor& monitor);

  const AMF::Simplified_animation& result() const { return m_result; }
  const AMF::Animation_level& level(std::size_t i) const { return m_result.levels.at(i); }
  std::vector<AMF::Rest_shape::Point> points(std::size_t level) const;

  // with levels, if they were measured
  const Simplify_animation::Level_report& report() const { return m_report; }

private:
  std::shared_ptr<const Animation_data> m_animation;
  AMF::Simplified_animation m_result;
  Simplify_animation::Level_report m_report;
};

} // namespace Python_module

#endif // PYTHON_MODULE_SIMPLIFICATION_DATA_H
