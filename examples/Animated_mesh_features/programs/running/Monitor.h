// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RUNNING_MONITOR_H
#define PROGRAMS_RUNNING_MONITOR_H

#include "running/Progress_bar.h"
#include "running/Stage_log.h"

#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>

#include <string>

namespace Programs {

// Watches a detection: a model of DetectionVisitor, which keeps the log, shows the progress and ends the detection when
// the program is interrupted. Who runs a detection from elsewhere than a terminal derives from it.
class Monitor
{
public:
  // `prefix` stands before the progress.
  Monitor(Stage_log& log, bool show_progress, const std::string& prefix = std::string());
  virtual ~Monitor() = default;
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  virtual void begin(CGAL::Animated_mesh_features::Stage stage);
  virtual bool progress(CGAL::Animated_mesh_features::Stage stage, double fraction);
  virtual void end(CGAL::Animated_mesh_features::Stage stage);

  Stage_log& log() { return m_log; }

private:
  Stage_log& m_log;
  Progress_bar m_bar;
};

} // namespace Programs

#endif // PROGRAMS_RUNNING_MONITOR_H
