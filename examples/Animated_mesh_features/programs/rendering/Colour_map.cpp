// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Colour_map.h"

#include <algorithm>

namespace Programs::Rendering {

namespace {

// Catmull and Rom's, with straight continuations at the ends.
Eigen::Array3d spline(const std::vector<Eigen::Array3d>& p, double t)
{
  const std::size_t last = p.size() - 1, i = (std::min)(std::size_t(t), last - 1);
  const double s = t - double(i);
  const Eigen::Array3d &b = p[i], &c = p[i + 1];
  const Eigen::Array3d a = i > 0 ? p[i - 1] : Eigen::Array3d(2 * b - c);
  const Eigen::Array3d d = i + 1 < last ? p[i + 2] : Eigen::Array3d(2 * c - b);
  return b + s / 2 * ((c - a) + s * ((2 * a - 5 * b + 4 * c - d) + s * (3 * (b - c) + d - a)));
}

} // namespace

Colour_map::Colour_map(const std::vector<Eigen::Array3d>& corners)
{
  const std::size_t fine = 4096;
  std::vector<Eigen::Array3d> curve(fine + 1);
  std::vector<double> length(fine + 1, 0);
  for (std::size_t i = 0; i <= fine; ++i) {
    curve[i] = spline(corners, double(i) / double(fine) * double(corners.size() - 1));
    if (i > 0) length[i] = length[i - 1] + (curve[i] - curve[i - 1]).matrix().norm();
  }
  m_colours.resize(size);
  for (std::size_t i = 0, j = 0; i < size; ++i) {
    const double at = length.back() * double(i) / double(size - 1);
    while (j + 2 < curve.size() && length[j + 1] < at) ++j;
    const double t = (at - length[j]) / (length[j + 1] - length[j]);
    m_colours[i] = linear_from_lab(curve[j] + t * (curve[j + 1] - curve[j]));
  }
}

Colour Colour_map::operator()(double t) const
{
  const double at = (std::min)(1., (std::max)(0., t)) * double(size - 1);
  const std::size_t i = (std::min)(std::size_t(at), size - 2);
  return mix(m_colours[i], m_colours[i + 1], float(at - double(i)));
}

} // namespace Programs::Rendering
