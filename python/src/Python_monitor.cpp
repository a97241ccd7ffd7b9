// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Python_monitor.h"

#include <utility>

namespace py = pybind11;

namespace Python_module {

Python_monitor::Python_monitor(py::object visitor)
  : Monitor(m_log, false)
  , m_visitor(std::move(visitor))
{
  if (!m_visitor.is_none() && PyCallable_Check(m_visitor.ptr()) == 0)
    throw py::type_error("the visitor must be callable: visitor(stage, fraction)");
}

// Time is not measured: the caller's clock is as good.
void Python_monitor::begin(CGAL::Animated_mesh_features::Stage) {}
void Python_monitor::end(CGAL::Animated_mesh_features::Stage) {}

bool Python_monitor::progress(CGAL::Animated_mesh_features::Stage stage, double fraction)
{
  return progress(name(stage), fraction);
}

bool Python_monitor::progress(const char* stage, double fraction)
{
  if (m_error) return false;
  py::gil_scoped_acquire acquire;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return m_visitor.is_none() || m_visitor(stage, fraction).ptr() != Py_False;
  } catch (...) {
    m_error = std::current_exception();
    return false;
  }
}

} // namespace Python_module
