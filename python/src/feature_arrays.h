// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_MODULE_FEATURE_ARRAYS_H
#define PYTHON_MODULE_FEATURE_ARRAYS_H

#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>
#include <vector>

namespace Python_module {

// A feature as a row of a structured array.
struct Feature_record
{
  std::int64_t vertex, frame;
  double time, refined_frame;
  std::array<double, 3> position, rest_position;
  std::array<std::int64_t, 3> triangle;
  std::array<double, 3> barycentric_coordinates;
  double sigma, tau, radius, response, amplitude, fit, strength;
  std::int64_t place, parent; // none: -1
  bool at_scale_limit;
};

// To be called once, before anything else here.
void register_feature_record();

typedef pybind11::array_t<Feature_record, pybind11::array::c_style> Feature_array;

// The records of a range of features.
template <class FeatureRange>
Feature_array array_of_features(const FeatureRange& features);

// The features of an array.
// throws Input_error if an index is negative.
std::vector<CGAL::Animated_mesh_features::Feature_point> features_of(const Feature_array& array);

} // namespace Python_module

#endif // PYTHON_MODULE_FEATURE_ARRAYS_H
