// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_MESH_DOG_H
#define ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_MESH_DOG_H

#include "Static_detector.h"
#include "quadratic_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Static_detectors {

// A. Zaharescu, E. Boyer, K. Varanasi, R. Horaud, Surface feature detection and description with applications to mesh
// matching, 2009: MeshDOG, on mean curvature. f_0 = H is smoothed again and again, f_k = f_(k-1) * g_k, by averages
// over a vertex and its one-ring with weights exp(-d^2 / (2 s_k^2)) of the distance d; s_k = 2^(ceil(k / c) / (c -
// 2)) mean edges with c = 6 steps in an octave and 3 octaves. Interest points are the extrema of f_k - f_(k-1) over
// the one-ring and both neighbouring steps, no edges (of the Hessian, from a quadratic over two rings, trace^2 / det
// < (r + 1)^2 / r, r = 10, as for images), the strongest 5 % of the number of vertices. The value of a vertex is its
// greatest difference.
//
// A step adds a variance per axis of v_k, half of the weighted mean of d^2, in the mean over all vertices; sigma is
// the square root of their sum. Since a step adds hardly more than the one before, plain differences of a smooth bump
// only decrease, and there would be no extremum over scale: differences are divided by v_k and multiplied by sigma^2.
class Mesh_dog : public Static_detector
{
public:
  Static_response operator()(const Surface& s) const override
  {
    const Vertex_measures measures = vertex_measures(s);
    const double edge = mean_edge(s);
    std::vector<double> before = measures.mean_curvature, sigma;
    std::vector<std::vector<double>> differences;
    double variance = 0;
    for (int k = 1; k <= octaves * steps; ++k) {
      const double width = std::exp2(double((k + steps - 1) / steps) / (steps - 2)) * edge;
      std::vector<double> after(s.size()), difference(s.size());
      const double added = smooth(s, before, width, after);
      variance += added;
      for (std::size_t v = 0; v < s.size(); ++v) difference[v] = variance / added * (after[v] - before[v]);
      differences.push_back(difference);
      sigma.push_back(std::sqrt(variance));
      before.swap(after);
    }
    Static_response response;
    response.values.assign(s.size(), 0);
    for (const std::vector<double>& d : differences)
      for (std::size_t v = 0; v < s.size(); ++v) response.values[v] = (std::max)(response.values[v], std::abs(d[v]));
    for (std::size_t k = 1; k + 1 < differences.size(); ++k)
      for (std::size_t v = 0; v < s.size(); ++v)
        if (is_extremum(s, differences, k, v) && !is_edge(s, measures.normals[v], differences[k], edge, v))
          response.points.push_back({v, sigma[k], std::abs(differences[k][v])});
    keep_strongest(response.points, s.size() / 20);
    return response;
  }

private:
  static constexpr int steps = 6, octaves = 3;

  static double mean_edge(const Surface& s)
  {
    double sum = 0;
    std::size_t number = 0;
    for (std::size_t v = 0; v < s.size(); ++v)
      for (std::size_t w : s.neighbours(v)) {
        sum += (s.points[w] - s.points[v]).norm();
        ++number;
      }
    return sum / double(number);
  }

  // returns the mean of the variances that are added.
  static double smooth(const Surface& s, const std::vector<double>& in, double width, std::vector<double>& out)
  {
    double variances = 0;
    for (std::size_t v = 0; v < s.size(); ++v) {
      double weights = 1, sum = in[v], squares = 0;
      for (std::size_t w : s.neighbours(v)) {
        const double square = (s.points[w] - s.points[v]).squaredNorm();
        const double weight = std::exp(-square / (2 * width * width));
        weights += weight;
        sum += weight * in[w];
        squares += weight * square;
      }
      out[v] = sum / weights;
      variances += squares / weights / 2;
    }
    return variances / double(s.size());
  }

  static bool is_extremum(const Surface& s, const std::vector<std::vector<double>>& d, std::size_t k, std::size_t v)
  {
    if (s.neighbours(v).empty() || d[k][v] == 0) return false;
    const double sign = d[k][v] > 0 ? 1 : -1, value = sign * d[k][v];
    for (std::size_t level : {k - 1, k, k + 1}) {
      if (level != k && !(sign * d[level][v] < value)) return false;
      for (std::size_t w : s.neighbours(v))
        if (!(sign * d[level][w] < value)) return false;
    }
    return true;
  }

  static bool is_edge(const Surface& s, const Point& normal, const std::vector<double>& values, double unit,
                      std::size_t v)
  {
    const double ratio = 10;
    const Point x = normal.unitOrthogonal(), y = normal.cross(x);
    std::vector<Eigen::Vector3d> samples;
    for (std::size_t w : rings(s, v, 2)) {
      const Point p = (s.points[w] - s.points[v]) / unit;
      samples.emplace_back(p.dot(x), p.dot(y), values[w]);
    }
    const auto fit = quadratic_fit(samples);
    if (!fit) return true;
    const double trace = (*fit)[0] + (*fit)[2], det = (*fit)[0] * (*fit)[2] - (*fit)[1] * (*fit)[1];
    return !(det > 0 && trace * trace * ratio < (ratio + 1) * (ratio + 1) * det);
  }
};

} // namespace Static_detectors

#endif // ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_MESH_DOG_H
