// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SUPPRESS_OVERLAPPED_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SUPPRESS_OVERLAPPED_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Detection/internal/Time_difference.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The norm in L2 of an event A exp(-x^2 / 2 sigma^2 - t^2 / 2 tau^2) along a limb and in time, but for a constant factor.
// Most events are bands around limbs; with the norm on a disc, whose factor is sigma, features of larger scales win.
template <class Feature>
double event_norm(const Feature& f)
{
  return f.strength * std::sqrt(f.sigma * f.tau);
}

// The cosine between two such events in L2, whose centres are that far from each other: 1 for equal ones.
template <class Feature>
double event_overlap(const Feature& a, const Feature& b, double distance, double time_difference)
{
  const double space = a.sigma * a.sigma + b.sigma * b.sigma, time = a.tau * a.tau + b.tau * b.tau;
  return std::sqrt(2 * a.sigma * b.sigma / space * (2 * a.tau * b.tau / time)) *
         std::exp(-distance * distance / (2 * space) - time_difference * time_difference / (2 * time));
}

// Which share of the strength of a feature is its own, if it overlaps one whose norm is the `1 / ratio`-fold: as in soft
// non-maximum suppression (Bodla et al. 2017) it decays with the overlap, the more the weaker the feature is. Exponent and
// least ratio are by measurement: what repeats on other bodies rises up to an exponent of 2, which loses events of twins.
inline double own_share(double overlap, double ratio)
{
  constexpr double exponent = 1.5, least_ratio = 0.2;
  return std::pow((std::max)(1 - overlap, 0.), exponent / (std::max)(ratio, least_ratio));
}

// Drops features of which one is kept that has a larger norm, and leaves them less than `least` of their strength: of the
// several scales at which a fold and the joint in it are minima, and of what lies on the flank of a stronger event, this
// keeps one. Its order remains. With a `least` of 0 all are kept. Distances on the surface are along edges, those in time
// `between` two. A ball of the surface of 3 sigma for each feature, and the pairs in it.
template <class Feature>
class Overlap_suppression
{
public:
  Overlap_suppression(const Rest_shape& shape, const std::vector<Feature>& features, const Time_difference& between)
    : m_features(&features)
    , m_between(between)
    , m_overlaps(features.size())
    , m_at_vertex(shape.number_of_vertices())
  {
    for (std::size_t i = 0; i < features.size(); ++i)
      m_at_vertex[features[i].vertex_index][octave(features[i].tau)].emplace_back(features[i].time, i);
    for (Octaves& octaves : m_at_vertex)
      for (auto& of_octave : octaves) std::sort(of_octave.second.begin(), of_octave.second.end());
    Bounded_dijkstra dijkstra(shape);
    for (std::size_t i = 0; i < features.size(); ++i) {
      const std::array<Rest_shape::Index, 1> source = {{Rest_shape::Index(features[i].vertex_index)}};
      for (Rest_shape::Index v : dijkstra.run(source, reach * features[i].sigma))
        if (!m_at_vertex[v].empty()) find_overlaps(i, v, dijkstra.distance(v));
    }
  }

  // The features that are kept, in their order.
  std::vector<Feature> kept(double least) const
  {
    const std::vector<Feature>& features = *m_features;
    std::vector<std::size_t> order(features.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return event_norm(features[i]) > event_norm(features[j]);
    });
    std::vector<char> visited(features.size(), 0), dropped(features.size(), 0);
    for (std::size_t i : order) {
      visited[i] = 1;
      if (dropped[i]) continue;
      for (const auto& [j, overlap] : m_overlaps[i]) {
        const double ratio = event_norm(features[j]) / event_norm(features[i]);
        if (!visited[j] && features[j].strength * own_share(overlap, ratio) < least) dropped[j] = 1;
      }
    }
    std::vector<Feature> result;
    for (std::size_t i = 0; i < features.size(); ++i)
      if (!dropped[i]) result.push_back(features[i]);
    return result;
  }

private:
  // The times and indices of features, by the octave of tau.
  typedef std::map<int, std::vector<std::pair<double, std::size_t>>> Octaves;

  // How far features count, in the larger sigma and tau of the two, and how much they overlap at least.
  static constexpr double reach = 3, least_overlap = 0.03;

  static int octave(double scale) { return int(std::floor(std::log2(scale))); }

  // Of feature `i` with those at `v` whose sigma is less, or the same and that come later: each pair once. Those of long tau
  // are looked for further away in time, so they are kept apart.
  void find_overlaps(std::size_t i, std::size_t v, double distance)
  {
    const Feature& f = (*m_features)[i];
    for (const auto& of_octave : m_at_vertex[v]) {
      const auto& row = of_octave.second;
      const double window = reach * (std::max)(f.tau, std::exp2(of_octave.first + 1));
      const auto around = [&](double time) {
        auto k = std::lower_bound(row.begin(), row.end(), std::make_pair(time - window, std::size_t(0)));
        for (; k != row.end() && k->first <= time + window; ++k) add(i, k->second, distance);
      };
      around(f.time);
      if (!(m_between.period() > 0)) continue;
      around(f.time - m_between.period());
      around(f.time + m_between.period());
    }
  }

  // In a cyclic animation twice, perhaps, which changes nothing.
  void add(std::size_t i, std::size_t j, double distance)
  {
    const Feature &f = (*m_features)[i], &g = (*m_features)[j];
    if (g.sigma > f.sigma || (g.sigma == f.sigma && j <= i)) return;
    const double later = m_between(f.time, g.time);
    if (later > reach * (std::max)(f.tau, g.tau)) return;
    const double overlap = event_overlap(f, g, distance, later);
    if (overlap < least_overlap) return;
    m_overlaps[i].emplace_back(j, overlap);
    m_overlaps[j].emplace_back(i, overlap);
  }

  const std::vector<Feature>* m_features;
  Time_difference m_between;
  std::vector<std::vector<std::pair<std::size_t, double>>> m_overlaps; // of each feature with others
  std::vector<Octaves> m_at_vertex;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SUPPRESS_OVERLAPPED_H
