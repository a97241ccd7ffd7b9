// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_HARRIS_3D_H
#define ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_HARRIS_3D_H

#include "Static_detector.h"
#include "quadratic_fit.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Static_detectors {

// I. Sipiran, B. Bustos, Harris 3D: a robust extension of the Harris operator for interest point detection on 3D
// meshes, 2011. The neighbourhood of a vertex are as many rings as it takes until one has a vertex farther than 1 %
// of the diagonal, two at least. Its points, seen from the vertex and turned so that their direction of least
// variance is z, are fitted by
//   z = p1 / 2 x^2 + p2 x y + p3 / 2 y^2 + p4 x + p5 y + p6.
// The derivatives, f_x = p1 x + p2 y + p4 and f_y = p2 x + p3 y + p5, are integrated with a Gaussian of variance s^2
// to
//   E = [A C; C B],  A = p4^2 + s^2 (p1^2 + p2^2),  B = p5^2 + s^2 (p2^2 + p3^2),  C = p4 p5 + s^2 p2 (p1 + p3),
// and the response is det E - .04 (trace E)^2. The paper has s^2 = 2 in the unit of the mesh; here the unit is the
// radius of the neighbourhood, so that the response has none. Interest points are local maxima over the one-ring, the
// strongest 1 % of the number of vertices. sigma: the radius that was asked for, 1 % of the diagonal.
class Harris_3d : public Static_detector
{
public:
  Static_response operator()(const Surface& s) const override
  {
    Static_response response;
    response.values.resize(s.size());
    for (std::size_t v = 0; v < s.size(); ++v) response.values[v] = harris(s, v);
    for (std::size_t v = 0; v < s.size(); ++v)
      if (response.values[v] > 0 && is_maximum(s, response.values, v))
        response.points.push_back({v, share * s.diagonal, response.values[v]});
    keep_strongest(response.points, (std::max)(std::size_t(1), s.size() / 100));
    return response;
  }

private:
  static constexpr double share = 0.01;
  static constexpr std::size_t most_rings = 20; // of a vertex from which nothing is that far

  static std::vector<std::size_t> neighbourhood(const Surface& s, std::size_t v)
  {
    std::size_t before = 1;
    for (std::size_t number = 1;; ++number) {
      std::vector<std::size_t> all = rings(s, v, number);
      double farthest = 0;
      for (std::size_t i = before; i < all.size(); ++i)
        farthest = (std::max)(farthest, (s.points[all[i]] - s.points[v]).norm());
      const bool is_all = all.size() == before;
      before = all.size();
      if ((number >= 2 && farthest >= share * s.diagonal) || is_all || number == most_rings) return all;
    }
  }

  static double harris(const Surface& s, std::size_t v)
  {
    const std::vector<std::size_t> around = neighbourhood(s, v);
    if (around.size() < 6) return 0;
    Point centre = Point::Zero();
    for (std::size_t w : around) centre += s.points[w];
    centre /= double(around.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    double radius = 0;
    for (std::size_t w : around) {
      const Point p = s.points[w] - centre;
      covariance += p * p.transpose();
      radius = (std::max)(radius, (s.points[w] - s.points[v]).norm());
    }
    if (!(radius > 0)) return 0;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
    axes.computeDirect(covariance);
    std::vector<Eigen::Vector3d> points;
    for (std::size_t w : around) {
      const Point p = (s.points[w] - s.points[v]) / radius;
      points.emplace_back(p.dot(axes.eigenvectors().col(2)), p.dot(axes.eigenvectors().col(1)),
                          p.dot(axes.eigenvectors().col(0)));
    }
    const auto fit = quadratic_fit(points);
    if (!fit) return 0;
    const auto& p = *fit;
    const double variance = 2, k = 0.04;
    const double a = p[3] * p[3] + variance * (p[0] * p[0] + p[1] * p[1]);
    const double b = p[4] * p[4] + variance * (p[1] * p[1] + p[2] * p[2]);
    const double c = p[3] * p[4] + variance * p[1] * (p[0] + p[2]);
    return a * b - c * c - k * (a + b) * (a + b);
  }
};

} // namespace Static_detectors

#endif // ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_HARRIS_3D_H
