// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_MONITOR_H
#define PYTHON_MONITOR_H

#include "running/Monitor.h"
#include "running/Stage_log.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>

#include <pybind11/pybind11.h>

#include <exception>

namespace Python_module {

// Tells a Python callable of the progress, `visitor(stage, fraction)`, which cancels by returning False or by an
// exception, and looks whether Ctrl-C was pressed. Computing goes on without Python's lock, which is taken for each call only.
class Python_monitor : public Programs::Monitor
{
public:
  // None: nobody is told.
  explicit Python_monitor(pybind11::object visitor);

  void begin(CGAL::Animated_mesh_features::Stage stage) override;
  bool progress(CGAL::Animated_mesh_features::Stage stage, double fraction) override;
  // the same of what has a name of its own
  bool progress(const char* stage, double fraction);
  void end(CGAL::Animated_mesh_features::Stage stage) override;

  // Runs `compute` without Python's lock. What the callable threw, or KeyboardInterrupt, takes the place of Cancelled.
  template <class Compute>
  auto run(const Compute& compute)
  {
    try {
      pybind11::gil_scoped_release release;
      return compute();
    } catch (const CGAL::Animated_mesh_features::Cancelled&) {
      if (m_error) std::rethrow_exception(m_error);
      throw;
    }
  }

private:
  Programs::Stage_log m_log;
  pybind11::object m_visitor;
  std::exception_ptr m_error; // of the callable
};

// A visitor of what is no stage of the library: whatever it is told of has the one name.
class Named_stage
{
public:
  Named_stage(Python_monitor& monitor, const char* name)
    : m_monitor(&monitor)
    , m_name(name)
  {}

  void begin(CGAL::Animated_mesh_features::Stage) {}
  bool progress(CGAL::Animated_mesh_features::Stage, double fraction) { return m_monitor->progress(m_name, fraction); }
  void end(CGAL::Animated_mesh_features::Stage) {}

private:
  Python_monitor* m_monitor;
  const char* m_name;
};

} // namespace Python_module

#endif // PYTHON_MONITOR_H
