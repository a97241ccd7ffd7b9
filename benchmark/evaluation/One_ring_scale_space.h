// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_ONE_RING_SCALE_SPACE_H
#define ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_ONE_RING_SCALE_SPACE_H

#include "Static_detector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Static_detectors {

// T. Darom, Y. Keller, Scale-invariant features for 3-D mesh models, 2012: a scale space of the shape itself. The
// points are averaged over the one-ring again and again; how far pass k + 1 moves a vertex is a difference of
// Gaussians of the coordinates. Divided by the variance that a pass adds at this vertex, so that it does not depend
// on the density of the mesh, and multiplied by the variance so far, so that scales can be compared, it is
//   d_k(v) = k |x_(k+1)(v) - x_k(v)|,   sigma_k(v)^2 = k / 2 mean |x_w - x_v|^2
// (the mean over the vertex and its one-ring in the frame). Interest points are maxima over the one-ring and the
// neighbouring scales; the value of a vertex is its greatest d_k. Scales: passes at a ratio of the square root of 2,
// 256 at most; one-rings are with the vertex itself, since without it points of regular meshes alternate.
class One_ring_scale_space : public Static_detector
{
public:
  Static_response operator()(const Surface& s) const override
  {
    std::vector<Point> points = s.points;
    std::vector<std::vector<double>> levels;
    std::size_t pass = 0;
    for (std::size_t k : passes) {
      while (pass < k) {
        points = averaged(s, points);
        ++pass;
      }
      const std::vector<Point> next = averaged(s, points);
      levels.emplace_back(s.size());
      for (std::size_t v = 0; v < s.size(); ++v) levels.back()[v] = double(k) * (next[v] - points[v]).norm();
    }
    Static_response response;
    response.values.assign(s.size(), 0);
    for (const std::vector<double>& d : levels)
      for (std::size_t v = 0; v < s.size(); ++v) response.values[v] = (std::max)(response.values[v], d[v]);
    for (std::size_t i = 1; i + 1 < levels.size(); ++i)
      for (std::size_t v = 0; v < s.size(); ++v)
        if (levels[i][v] > levels[i - 1][v] && levels[i][v] > levels[i + 1][v] && is_maximum(s, levels[i], v))
          response.points.push_back({v, std::sqrt(double(passes[i]) * variance_of_pass(s, v)), levels[i][v]});
    return response;
  }

private:
  static constexpr std::array<std::size_t, 16> passes = {{1, 2, 3, 4, 6, 8, 11, 16, 23, 32, 45, 64, 91, 128, 181, 256}};

  static std::vector<Point> averaged(const Surface& s, const std::vector<Point>& points)
  {
    std::vector<Point> result(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
      Point sum = points[v];
      for (std::size_t w : s.neighbours(v)) sum += points[w];
      result[v] = sum / double(s.neighbours(v).size() + 1);
    }
    return result;
  }

  static double variance_of_pass(const Surface& s, std::size_t v)
  {
    double squares = 0;
    for (std::size_t w : s.neighbours(v)) squares += (s.points[w] - s.points[v]).squaredNorm();
    return squares / double(s.neighbours(v).size() + 1) / 2;
  }
};

} // namespace Static_detectors

#endif // ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_ONE_RING_SCALE_SPACE_H
