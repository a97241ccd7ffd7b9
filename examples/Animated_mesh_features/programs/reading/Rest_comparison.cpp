// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Rest_comparison.h"

#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>

#include <algorithm>
#include <cmath>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

// of the lengths in the middle frame over those of the shape; 0 if there are none
double median_ratio(const Points& points, const Sequence& sequence)
{
  const AMF::Vertex_trajectories<FT>& t = sequence.trajectories();
  const std::size_t f = sequence.number_of_frames() / 2;
  std::vector<double> ratios;
  for (const AMF::Rest_shape::Edge& e : sequence.rest_shape().edges()) {
    const double length = (points[e.target] - points[e.source]).norm();
    if (length > 0) ratios.push_back((t.point(e.target, f) - t.point(e.source, f)).norm() / length);
  }
  if (ratios.empty()) return 0;
  const auto middle = ratios.begin() + std::ptrdiff_t(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return std::isfinite(*middle) ? *middle : 0;
}

} // namespace

std::optional<std::size_t> frame_at(const Points& points, const Sequence& sequence)
{
  if (points.empty()) return std::nullopt;
  // Texts have six digits as a rule, point caches seven.
  const double rounding = 1e-5;
  const AMF::Vertex_trajectories<FT>& t = sequence.trajectories();
  double extent = 0;
  for (const auto& p : points)
    extent = (std::max)({extent, (p - points[0]).cwiseAbs().maxCoeff(), rounding * p.cwiseAbs().maxCoeff()});
  const double tolerance = rounding * extent;
  std::vector<std::size_t> candidates(sequence.number_of_frames());
  for (std::size_t f = 0; f < candidates.size(); ++f) candidates[f] = f;
  for (std::size_t v = 0; v < points.size() && !candidates.empty(); ++v)
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [&](std::size_t f) {
                                      return !((t.point(v, f) - points[v]).cwiseAbs().maxCoeff() <= tolerance);
                                    }),
                     candidates.end());
  return candidates.empty() ? std::nullopt : std::optional<std::size_t>(candidates.front());
}

Rest_comparison compare_with_frames(const Points& points, const Sequence& sequence, bool scaled)
{
  const AMF::Vertex_trajectories<FT>& t = sequence.trajectories();
  Rest_comparison result;
  result.ratio = median_ratio(points, sequence);
  const double factor = scaled ? result.ratio : 1;
  std::vector<double> changes(sequence.number_of_frames(), 0);
  double lengths = 0;
  for (const AMF::Rest_shape::Edge& e : sequence.rest_shape().edges()) {
    const double length = factor * (points[e.target] - points[e.source]).norm();
    lengths += length * length;
    for (std::size_t f = 0; f < changes.size(); ++f) {
      const double change = (t.point(e.target, f) - t.point(e.source, f)).norm() - length;
      changes[f] += change * change;
    }
  }
  const auto least = std::min_element(changes.begin(), changes.end());
  result.frame = std::size_t(least - changes.begin());
  result.change = lengths > 0 ? std::sqrt(*least / lengths) : 0;
  return result;
}

bool begins_still(const Sequence& sequence)
{
  const double still = 0.02;
  const AMF::Vertex_trajectories<FT>& t = sequence.trajectories();
  std::vector<double> changes(sequence.number_of_frames() - 1, 0);
  for (const AMF::Rest_shape::Edge& e : sequence.rest_shape().edges()) {
    double before = 0;
    for (std::size_t f = 0; f <= changes.size(); ++f) {
      const double length = (t.point(e.target, f) - t.point(e.source, f)).norm();
      if (f > 0) changes[f - 1] += (length - before) * (length - before);
      before = length;
    }
  }
  return changes.front() <= still * still * *std::max_element(changes.begin(), changes.end());
}

} // namespace Programs
