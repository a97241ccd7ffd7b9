// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_MODULE_BIND_H
#define PYTHON_MODULE_BIND_H

#include <pybind11/pybind11.h>

// The parts of the extension module. What stands in front of it, with the documentation, is Python: functions here take
// what that has checked, and options as texts (see Arguments.h). A part for another room of the package is a file
// bind_<room>.cpp with a function that is called in module.cpp, and a Python file beside the others.

namespace Python_module {

void bind_exceptions(pybind11::module_& module);
void bind_animation(pybind11::module_& module);
void bind_detection(pybind11::module_& module);
void bind_evaluation(pybind11::module_& module);
void bind_comparison(pybind11::module_& module);
void bind_simplification(pybind11::module_& module);
void bind_writing(pybind11::module_& module);
void bind_views(pybind11::module_& module);

} // namespace Python_module

#endif // PYTHON_MODULE_BIND_H
