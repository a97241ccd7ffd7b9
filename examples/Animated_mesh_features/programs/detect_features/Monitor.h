// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_MONITOR_H
#define DETECT_FEATURES_MONITOR_H

#include "detect_features/Interruption.h"
#include "detect_features/Progress_bar.h"
#include "detect_features/Stage_log.h"

#include <CGAL/Animated_mesh_features/Numerics/parallel/Default_visitor.h>

namespace Detect_features {

// Watches a detection: a model of DetectionVisitor.
class Monitor
{
public:
  Monitor(Stage_log& log, bool show_progress)
    : m_log(log)
    , m_bar(show_progress)
  {}

  void begin(CGAL::Animated_mesh_features::Stage stage) { m_log.begin(name(stage)); }

  bool progress(CGAL::Animated_mesh_features::Stage stage, double fraction)
  {
    m_bar.show(name(stage), fraction);
    return Interruption::signal() == 0;
  }

  void end(CGAL::Animated_mesh_features::Stage) { m_log.end(); }

  Stage_log& log() { return m_log; }

private:
  Stage_log& m_log;
  Progress_bar m_bar;
};

} // namespace Detect_features

#endif // DETECT_FEATURES_MONITOR_H
