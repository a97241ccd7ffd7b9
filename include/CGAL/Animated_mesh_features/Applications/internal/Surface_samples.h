// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_SURFACE_SAMPLES_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_SURFACE_SAMPLES_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Points of a surface that move with it: in each triangle at least one, in large ones more, by the sequence of
// M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018 (additive, of the plastic number), folded
// into the triangle; and all vertices, which count for the largest distance only.
struct Surface_samples
{
  struct Sample
  {
    Rest_shape::Index triangle;
    std::array<double, 3> place; // barycentric coordinates
    double share;                // of the triangle's area
  };

  std::vector<Sample> samples;

  Surface_samples(const std::vector<Rest_shape::Triangle>& triangles, const std::vector<Rest_shape::Point>& points,
                  std::size_t number)
  {
    std::vector<double> areas;
    double all = 0;
    for (const Rest_shape::Triangle& t : triangles) {
      areas.push_back((points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm() / 2);
      all += areas.back();
    }
    std::vector<char> is_taken(points.size(), 0);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const double ideal = all > 0 ? areas[t] / all * double(number) : 0;
      const std::size_t n = (std::max)(std::size_t(1), std::size_t(std::ceil(ideal - .5)));
      for (std::size_t i = 0; i < n; ++i) {
        std::array<double, 3> b = {{1. / 3, 1. / 3, 1. / 3}};
        if (n > 1) {
          double unused;
          double u = std::modf(.5 + .7548776662466927 * double(i), &unused),
                 v = std::modf(.5 + .5698402909980532 * double(i), &unused);
          if (u + v > 1) u = 1 - u, v = 1 - v;
          b = {{1 - u - v, u, v}};
        }
        samples.push_back({Rest_shape::Index(t), b, 1. / double(n)});
      }
      for (std::size_t k = 0; k < 3; ++k) {
        if (is_taken[triangles[t][k]] != 0) continue;
        is_taken[triangles[t][k]] = 1;
        std::array<double, 3> b = {{0, 0, 0}};
        b[k] = 1;
        samples.push_back({Rest_shape::Index(t), b, 0.});
      }
    }
  }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_SURFACE_SAMPLES_H
