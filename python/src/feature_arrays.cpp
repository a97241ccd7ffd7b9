// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feature_arrays.h"

#include "reading/Sequence.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <string>

namespace py = pybind11;
namespace AMF = CGAL::Animated_mesh_features;

namespace Python_module {

namespace {

Feature_record record(const AMF::Feature_point& f)
{
  Feature_record r = {};
  r.vertex = std::int64_t(f.vertex_index);
  r.frame = std::int64_t(f.frame);
  r.time = f.time;
  r.refined_frame = f.refined_frame;
  r.position = f.position;
  r.rest_position = f.rest_position;
  for (std::size_t i = 0; i < 3; ++i) r.triangle[i] = std::int64_t(f.triangle[i]);
  r.barycentric_coordinates = f.barycentric_coordinates;
  r.sigma = f.sigma;
  r.tau = f.tau;
  r.radius = f.radius();
  r.response = f.response;
  r.amplitude = f.amplitude;
  r.fit = f.fit;
  r.strength = f.strength;
  r.place = std::int64_t(f.place);
  r.parent = f.parent == AMF::Feature_point::none ? -1 : std::int64_t(f.parent);
  r.at_scale_limit = f.at_scale_limit;
  return r;
}

std::size_t checked(std::int64_t i, const char* what, std::size_t feature)
{
  if (i < 0)
    throw AMF::Input_error("feature " + std::to_string(feature) + ": its " + what + " is " + std::to_string(i));
  return std::size_t(i);
}

AMF::Feature_point feature(const Feature_record& r, std::size_t i)
{
  AMF::Feature_point f;
  f.vertex_index = checked(r.vertex, "vertex", i);
  f.frame = checked(r.frame, "frame", i);
  f.time = r.time;
  f.refined_frame = r.refined_frame;
  f.position = r.position;
  f.rest_position = r.rest_position;
  for (std::size_t k = 0; k < 3; ++k) f.triangle[k] = checked(r.triangle[k], "triangle", i);
  f.barycentric_coordinates = r.barycentric_coordinates;
  f.sigma = r.sigma;
  f.tau = r.tau;
  f.response = r.response;
  f.amplitude = r.amplitude;
  f.fit = r.fit;
  f.strength = r.strength;
  f.place = checked(r.place, "place", i);
  f.parent = r.parent < 0 ? AMF::Feature_point::none : std::size_t(r.parent);
  f.at_scale_limit = r.at_scale_limit;
  return f;
}

} // namespace

void register_feature_record()
{
  PYBIND11_NUMPY_DTYPE(Feature_record, vertex, frame, time, refined_frame, position, rest_position, triangle,
                       barycentric_coordinates, sigma, tau, radius, response, amplitude, fit, strength, place, parent,
                       at_scale_limit);
}

template <class FeatureRange>
Feature_array array_of_features(const FeatureRange& features)
{
  Feature_array array{py::ssize_t(features.size())};
  Feature_record* out = array.mutable_data();
  for (const AMF::Feature_point& f : features) *out++ = record(f);
  return array;
}

template Feature_array array_of_features(const std::vector<AMF::Feature_point>&);
template Feature_array array_of_features(const std::vector<Programs::Feature>&);

std::vector<AMF::Feature_point> features_of(const Feature_array& array)
{
  if (array.ndim() != 1) throw AMF::Input_error("features: an array of one dimension is expected");
  std::vector<AMF::Feature_point> features;
  for (py::ssize_t i = 0; i < array.shape(0); ++i) features.push_back(feature(array.data()[i], std::size_t(i)));
  return features;
}

} // namespace Python_module
