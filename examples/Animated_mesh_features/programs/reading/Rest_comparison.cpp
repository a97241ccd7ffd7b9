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

typedef AMF::Rest_shape::Edge Edge;

template <class Task>
void for_some_edges(const Sequence& sequence, const Task& task)
{
  const std::size_t most_edges = 30000;
  const std::vector<Edge>& edges = sequence.rest_shape().edges();
  for (std::size_t i = 0, step = edges.size() / most_edges + 1; i < edges.size(); i += step) task(edges[i]);
}

double length_in_frame(const Sequence& sequence, const Edge& e, std::size_t f)
{
  return (sequence.trajectories().point(e.target, f) - sequence.trajectories().point(e.source, f)).norm();
}

// of the lengths in the middle frame over those of the shape; 0 if there are none
double median_ratio(const Rest_points& points, const Sequence& sequence)
{
  std::vector<double> ratios;
  for_some_edges(sequence, [&](const Edge& e) {
    const double length = (points[e.target] - points[e.source]).norm();
    if (length > 0) ratios.push_back(length_in_frame(sequence, e, sequence.number_of_frames() / 2) / length);
  });
  if (ratios.empty()) return 0;
  const auto middle = ratios.begin() + std::ptrdiff_t(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return std::isfinite(*middle) ? *middle : 0;
}

// Of the edges in each frame against those of a shape, relative.
template <class Length>
std::vector<double> edge_changes(const Sequence& sequence, const Length& length_in_shape)
{
  std::vector<double> changes(sequence.number_of_frames(), 0);
  double lengths = 0;
  for_some_edges(sequence, [&](const Edge& e) {
    const double length = length_in_shape(e);
    lengths += length * length;
    for (std::size_t f = 0; f < changes.size(); ++f) {
      const double change = length_in_frame(sequence, e, f) - length;
      changes[f] += change * change;
    }
  });
  for (double& change : changes) change = lengths > 0 ? std::sqrt(change / lengths) : 0;
  return changes;
}

} // namespace

std::optional<std::size_t> frame_at(const Rest_points& points, const Sequence& sequence)
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

Rest_comparison compare_with_frames(const Rest_points& points, const Sequence& sequence, bool scaled)
{
  Rest_comparison result;
  result.ratio = median_ratio(points, sequence);
  const double factor = scaled ? result.ratio : 1;
  const std::vector<double> changes = edge_changes(
      sequence, [&](const Edge& e) { return factor * (points[e.target] - points[e.source]).norm(); });
  const auto least = std::min_element(changes.begin(), changes.end());
  result.frame = std::size_t(least - changes.begin());
  result.change = *least;
  const std::vector<double> others =
      edge_changes(sequence, [&](const Edge& e) { return length_in_frame(sequence, e, result.frame); });
  result.spread = *std::max_element(others.begin(), others.end());
  return result;
}

bool begins_still(const Sequence& sequence)
{
  const double still = 0.02;
  std::vector<double> changes(sequence.number_of_frames() - 1, 0);
  for_some_edges(sequence, [&](const Edge& e) {
    double before = length_in_frame(sequence, e, 0);
    for (std::size_t f = 0; f < changes.size(); ++f) {
      const double length = length_in_frame(sequence, e, f + 1);
      changes[f] += (length - before) * (length - before);
      before = length;
    }
  });
  return changes.front() <= still * still * *std::max_element(changes.begin(), changes.end());
}

} // namespace Programs
