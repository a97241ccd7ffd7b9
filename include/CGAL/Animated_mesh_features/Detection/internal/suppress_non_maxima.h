// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SUPPRESS_NON_MAXIMA_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SUPPRESS_NON_MAXIMA_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Detection/internal/Time_difference.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Scales that differ by more than this factor are different events, even in the same place: the flexing of a knee and
// the swing of the leg. Dropping the weaker one of such a pair makes the outcome depend on which of them is stronger by
// a hair.
constexpr double like_scales = 1.5;

inline bool are_alike(double scale_1, double scale_2)
{
  return scale_1 <= like_scales * scale_2 && scale_2 <= like_scales * scale_1;
}

// Indices of features at each vertex, so that those at like scales of a time come quickly: their number does not grow with
// the number of frames.
template <class Feature>
class Features_at_vertices
{
  // tau in classes so wide that what is alike is in neighbouring ones, then time
  typedef std::pair<double, double> Key;

public:
  Features_at_vertices(std::size_t number_of_vertices, const std::vector<Feature>& features,
                       const Time_difference& between)
    : m_at_vertex(number_of_vertices)
    , m_period(between.period())
  {
    for (std::size_t i = 0; i < features.size(); ++i)
      m_at_vertex[features[i].vertex_index].emplace_back(Key(tau_class(features[i]), features[i].time), i);
    for (auto& row : m_at_vertex) std::sort(row.begin(), row.end());
  }

  // visit(j) for all features at `v` that may be like `f` in tau, and within its time; in a cyclic animation twice, perhaps.
  template <class Visit>
  void for_each_like(const Feature& f, std::size_t v, const Visit& visit) const
  {
    const auto& row = m_at_vertex[v];
    const double reach = class_width * f.tau; // tau of what is alike is less than that
    for (int step : {-1, 0, 1}) {
      const double c = tau_class(f) + step;
      const auto visit_around = [&](double time) {
        auto i = std::lower_bound(row.begin(), row.end(), std::make_pair(Key(c, time - reach), std::size_t(0)));
        for (; i != row.end() && i->first.first == c && i->first.second <= time + reach; ++i) visit(i->second);
      };
      visit_around(f.time);
      if (!(m_period > 0)) continue;
      visit_around(f.time - m_period);
      visit_around(f.time + m_period);
    }
  }

private:
  static constexpr double class_width = 1.01 * like_scales; // a bit more, for the sake of rounding

  static double tau_class(const Feature& f) { return std::floor(std::log(f.tau) / std::log(class_width)); }

  std::vector<std::vector<std::pair<Key, std::size_t>>> m_at_vertex;
  double m_period; // 0: not cyclic
};

// Of features sorted by strength, strongest first, drops those of which a stronger one that is kept is within
// max(sigma) on the surface and max(tau) in time, at like scales. Distances on the surface are along edges, those in time
// `between` two.
template <class Feature>
std::vector<Feature> suppress_non_maxima(const Rest_shape& shape, const std::vector<Feature>& features,
                                         const Time_difference& between = Time_difference())
{
  const Features_at_vertices<Feature> at_vertices(shape.number_of_vertices(), features, between);
  std::vector<char> dropped(features.size(), 0);
  std::vector<Feature> kept;
  Bounded_dijkstra dijkstra(shape);
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (dropped[i]) continue;
    const Feature& strong = features[i];
    kept.push_back(strong);
    const std::array<Rest_shape::Index, 1> source = {{Rest_shape::Index(strong.vertex_index)}};
    for (Rest_shape::Index v : dijkstra.run(source, like_scales * strong.sigma))
      at_vertices.for_each_like(strong, v, [&](std::size_t j) {
        const Feature& weak = features[j];
        if (j > i && dijkstra.distance(v) <= (std::max)(strong.sigma, weak.sigma) &&
            between(strong.time, weak.time) <= (std::max)(strong.tau, weak.tau) &&
            are_alike(strong.sigma, weak.sigma) && are_alike(strong.tau, weak.tau))
          dropped[j] = 1;
      });
  }
  return kept;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_SUPPRESS_NON_MAXIMA_H
