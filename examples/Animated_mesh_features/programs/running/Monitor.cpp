// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "running/Monitor.h"

#include "running/Interruption.h"

namespace Programs {

Monitor::Monitor(Stage_log& log, bool show_progress, const std::string& prefix)
  : m_log(log)
  , m_bar(show_progress, prefix)
{}

void Monitor::begin(CGAL::Animated_mesh_features::Stage stage)
{
  m_log.begin(name(stage));
}

bool Monitor::progress(CGAL::Animated_mesh_features::Stage stage, double fraction)
{
  m_bar.show(name(stage), fraction);
  return Interruption::signal() == 0;
}

void Monitor::end(CGAL::Animated_mesh_features::Stage)
{
  m_log.end();
}

} // namespace Programs
