// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bind.h"
#include "Arguments.h"
#include "feature_arrays.h"

#include <pybind11/stl.h>

namespace py = pybind11;

PYBIND11_MODULE(_core, m)
{
  using namespace Python_module;
  m.attr("__version__") = ANIMATED_MESH_FEATURES_VERSION;
#ifdef CGAL_LINKED_WITH_TBB
  m.attr("has_threads") = true;
#else
  m.attr("has_threads") = false;
#endif
  register_feature_record();
  m.attr("feature_dtype") = py::dtype::of<Feature_record>();
  m.def("help_of", &help_of);
  m.attr("READING") = int(READING);
  m.attr("METHOD") = int(METHOD);
  m.attr("OUTPUT") = int(OUTPUT);
  m.attr("COMPARISON") = int(COMPARISON);
  m.attr("SIMPLIFICATION") = int(SIMPLIFICATION);
  bind_exceptions(m);
  bind_animation(m);
  bind_detection(m);
  bind_evaluation(m);
  bind_comparison(m);
  bind_simplification(m);
  bind_writing(m);
  bind_views(m);
}
