// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Body_view.h"

#include "rendering/Depth_map.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace Programs::Rendering {

namespace {

// How well a body stands if this axis points up: how far inside of the bounding rectangle of its lowest points its
// centre is, as a fraction of its half width; 1 for a box, negative for what topples.
double stability(const std::vector<Eigen::Vector3d>& points, int axis)
{
  const double lowest_part = 0.06; // of the height: feet
  const double most = (std::numeric_limits<double>::max)();
  Eigen::Vector3d low = Eigen::Vector3d::Constant(most), high = -low, mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p), mean += p;
  mean /= double(points.size());
  const double level = low[axis] + lowest_part * (high[axis] - low[axis]);
  Eigen::Vector3d foot_low = Eigen::Vector3d::Constant(most), foot_high = -foot_low;
  for (const Eigen::Vector3d& p : points)
    if (p[axis] <= level) foot_low = foot_low.cwiseMin(p), foot_high = foot_high.cwiseMax(p);
  double result = 1;
  for (int i : {(axis + 1) % 3, (axis + 2) % 3}) {
    const double half_width = (high[i] - low[i]) / 2;
    if (!(half_width > 0)) continue;
    result = (std::min)(result, (std::min)(mean[i] - foot_low[i], foot_high[i] - mean[i]) / half_width);
  }
  return result;
}

} // namespace

int probable_up_axis(const std::vector<Eigen::Vector3d>& points)
{
  const double clear_difference = 0.05;
  return stability(points, 2) > stability(points, 1) + clear_difference ? 2 : 1;
}

double good_azimuth(const std::vector<Surface>& bodies, const std::vector<std::vector<Sphere>>& spheres,
                    View_direction view)
{
  const double beside = 30;
  const int first = (view.up_axis + 1) % 3, second = (view.up_axis + 2) % 3;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const Surface& body : bodies) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector3d& p : body.points) mean += Eigen::Vector2d(p[first], p[second]);
    mean /= double(body.points.size());
    for (const Eigen::Vector3d& p : body.points) {
      const Eigen::Vector2d d = Eigen::Vector2d(p[first], p[second]) - mean;
      covariance += d * d.transpose();
    }
  }
  const Eigen::Vector2d thin = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvectors().col(0);
  const double middle = std::atan2(thin[1], thin[0]) * 180 / EIGEN_PI;
  double best = middle + beside, most = -1;
  for (double azimuth : {middle + beside, middle - beside, middle + 180 + beside, middle + 180 - beside}) {
    view.azimuth = azimuth;
    double seen = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      Eigen::Vector3d low = bodies[i].points.front(), high = low;
      for (const Eigen::Vector3d& p : bodies[i].points) low = low.cwiseMin(p), high = high.cwiseMax(p);
      const Depth_map depth(bodies[i], (low + high) / 2, (high - low).norm() / 2, view.to_camera());
      for (const Sphere& s : spheres[i]) seen += s.opacity * double(depth.visibility(s.centre, view.to_camera()));
    }
    // by more than rounding, or symmetric bodies would be seen from anywhere
    if (seen > most * (1 + 1e-6)) most = seen, best = azimuth;
  }
  return best;
}

} // namespace Programs::Rendering
