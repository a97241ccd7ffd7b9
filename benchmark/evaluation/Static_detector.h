// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_STATIC_DETECTOR_H
#define ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_STATIC_DETECTOR_H

#include "Surface.h"

#include <cstddef>
#include <vector>

namespace Static_detectors {

struct Interest_point
{
  std::size_t vertex;
  double sigma; // length
  double strength;
};

// What a detector sees in a frame.
struct Static_response
{
  std::vector<double> values;         // how salient each vertex is; compared between frames
  std::vector<Interest_point> points; // in no order

  // what finish() makes the values of, if they depend on all frames: [level][vertex]
  std::vector<std::vector<float>> levels;
};

// A detector of interest points of static shapes, frame by frame.
class Static_detector
{
public:
  virtual ~Static_detector() = default;

  // is told the rest shape before the first frame.
  virtual void prepare(const Surface&) {}

  // called for several frames at the same time.
  virtual Static_response operator()(const Surface& frame) const = 0;

  // after the last frame, for what needs all of them; the surface is that of any frame.
  virtual void finish(const Surface&, std::vector<Static_response>&) const {}
};

// Leaves that many points, the strongest ones.
inline void keep_strongest(std::vector<Interest_point>& points, std::size_t number)
{
  std::sort(points.begin(), points.end(), [](const Interest_point& a, const Interest_point& b) {
    return a.strength > b.strength || (a.strength == b.strength && a.vertex < b.vertex);
  });
  if (points.size() > number) points.resize(number);
}

} // namespace Static_detectors

#endif // ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_STATIC_DETECTOR_H
