// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_EVENT_DIFFERENCES_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_EVENT_DIFFERENCES_H

#include <CGAL/Animated_mesh_features/Applications/Animation_signature.h>
#include <CGAL/Animated_mesh_features/Applications/Time_alignment.h>
#include <CGAL/Animated_mesh_features/Descriptors/feature_difference.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

How near is near enough for two events of two takes to be the same one.
*/
struct Event_gates
{
  double place = 0.05;  ///< on the rest shapes, as a share of the diagonal; \f$\sigma\f$ if that is more
  double profile = 0.3; ///< the largest distance of profiles, if the takes are of different meshes
  double frames = 1.5;  ///< of the coarser frames, after the alignment; half of \f$\tau\f$ if that is more
  double factor = 2;    ///< the largest ratio of two values of \f$\sigma\f$, and of \f$\tau\f$

  /// looks whether all numbers are in their ranges.
  /// \throw Option_error if one is not.
  void check() const
  {
    if (!(place >= 0) || !(profile >= 0) || !(frames >= 0) || !(factor >= 1))
      throw Option_error("gates must not be negative, and a ratio is at least 1");
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

An event that two takes do not have in common, or have differently.
*/
struct Event_difference
{
  std::optional<std::size_t> a; ///< its rank in the first take, if it is there
  std::optional<std::size_t> b; ///< its rank in the second take, if it is there
  double amplitude = 0;         ///< the amplitude of an event that is in one take only, else the difference of both
};

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

tells in what two takes of a motion differ: pairs events that are at the same place, after the alignment at the same
time, and of similar scales, the nearest first, each with one partner, and lists what is left, and what has another
amplitude.

`O(A B)` for `A` and `B` events.

\param a, b the takes. If they have as many vertices, and diagonals within 5 %, events are compared by their places at
  rest, else by their profiles on the body; if there are none, by time and scales alone.
\param alignment of their times, see `align_animations()`.
\param gates how near is near enough.
\returns differences with the largest amplitude first; those of pairs, too, however small.
\throw Option_error if a gate is out of its range.
*/
inline std::vector<Event_difference> event_differences(const Animation_signature& a, const Animation_signature& b,
                                                       const Time_alignment& alignment,
                                                       const Event_gates& gates = Event_gates())
{
  gates.check();
  const std::vector<Feature_point>& x = a.events.features;
  const std::vector<Feature_point>& y = b.events.features;
  const bool is_same_body = a.vertices == b.vertices && std::abs(a.diagonal - b.diagonal) <= 0.05 * a.diagonal;
  const auto distance = [&](std::size_t i, std::size_t j) { // relative to the gate
    if (is_same_body) {
      double squares = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double d = x[i].rest_position[k] - y[j].rest_position[k];
        squares += d * d;
      }
      return std::sqrt(squares) / (std::max)({gates.place * a.diagonal, x[i].sigma, y[j].sigma});
    }
    if (i >= a.events.places.size() || j >= b.events.places.size()) return 0.;
    return descriptor_distance(a.events.places[i], b.events.places[j], a.events.places.length()) / gates.profile;
  };
  const double frame = (std::max)(a.frame_duration, b.frame_duration), rounding = 1e-9;
  const auto are_alike = [&](double p, double q) {
    return (std::max)(p, q) <= gates.factor * (std::min)(p, q) + rounding;
  };

  std::vector<std::tuple<double, std::size_t, std::size_t>> near;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < y.size(); ++j) {
      if (!are_alike(x[i].sigma / a.diagonal, y[j].sigma / b.diagonal) || !are_alike(x[i].tau, y[j].tau)) continue;
      const double late = std::abs(alignment.lateness(x[i].time, y[j].time));
      const double time = (late - rounding) / (std::max)({gates.frames * frame, x[i].tau / 2, y[j].tau / 2});
      const double place = distance(i, j);
      if (time <= 1 && place <= 1) near.emplace_back(place * place + time * time, i, j);
    }
  std::sort(near.begin(), near.end());
  std::vector<char> of_a(x.size(), 0), of_b(y.size(), 0);
  std::vector<Event_difference> result;
  for (const auto& [d, i, j] : near) {
    if (of_a[i] != 0 || of_b[j] != 0) continue;
    of_a[i] = of_b[j] = 1;
    result.push_back({i, j, std::abs(x[i].amplitude - y[j].amplitude)});
  }
  for (std::size_t i = 0; i < x.size(); ++i)
    if (of_a[i] == 0) result.push_back({i, std::nullopt, x[i].amplitude});
  for (std::size_t j = 0; j < y.size(); ++j)
    if (of_b[j] == 0) result.push_back({std::nullopt, j, y[j].amplitude});
  std::stable_sort(result.begin(), result.end(),
                   [](const Event_difference& p, const Event_difference& q) { return p.amplitude > q.amplitude; });
  return result;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_EVENT_DIFFERENCES_H
