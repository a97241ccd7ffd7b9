// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <exception>

namespace py = pybind11;
namespace AMF = CGAL::Animated_mesh_features;

namespace Python_module {

namespace {

// The classes are Python's own, see _exceptions.py. They are never given back, as modules that are left over at exit.
struct Classes
{
  py::object error, input, option, output, numerical, cancelled;
};

Classes* classes = nullptr;

void translate(std::exception_ptr e)
{
  const auto set = [](const py::object& type, const std::exception& what) { PyErr_SetString(type.ptr(), what.what()); };
  try {
    if (e) std::rethrow_exception(e);
  } catch (const AMF::Input_error& x) {
    set(classes->input, x);
  } catch (const AMF::Option_error& x) {
    set(classes->option, x);
  } catch (const AMF::Output_error& x) {
    set(classes->output, x);
  } catch (const AMF::Numerical_error& x) {
    set(classes->numerical, x);
  } catch (const AMF::Cancelled& x) {
    set(classes->cancelled, x);
  } catch (const AMF::Error& x) {
    set(classes->error, x);
  }
}

} // namespace

void bind_exceptions(py::module_&)
{
  const py::module_ python = py::module_::import("animated_mesh_features._exceptions");
  classes = new Classes{python.attr("Error"),       python.attr("InputError"),     python.attr("OptionError"),
                        python.attr("OutputError"), python.attr("NumericalError"), python.attr("Cancelled")};
  py::register_exception_translator(&translate);
}

} // namespace Python_module
