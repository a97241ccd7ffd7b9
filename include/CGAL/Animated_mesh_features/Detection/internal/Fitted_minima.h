// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_FITTED_MINIMA_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_FITTED_MINIMA_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/vertex_areas.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_selection.h>
#include <CGAL/Animated_mesh_features/Detection/feature_fit.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Scale_space/Scale_levels.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Minima of a response with their fits, which are measured when a selection asks for them: a fit costs as much as a look
// at all samples around it, and is at most 1, so that the amplitude alone tells which minima are too weak.
template <class Feature>
class Fitted_minima
{
public:
  Fitted_minima() = default;

  // `weighs_by_fit`: whether the strength of a minimum is its amplitude times its fit, or its amplitude; both times its
  // shares of the two ranges of scales.
  Fitted_minima(std::vector<Feature> minima, bool weighs_by_fit, Scale_fade sigma_fade, Scale_fade tau_fade)
    : m_minima(std::move(minima))
    , m_weighs_by_fit(weighs_by_fit)
    , m_sigma_fade(sigma_fade)
    , m_tau_fade(tau_fade)
  {
    std::sort(m_minima.begin(), m_minima.end(), [](const Feature& a, const Feature& b) {
      return std::tie(b.amplitude, a.vertex_index, a.time, a.sigma, a.tau) <
             std::tie(a.amplitude, b.vertex_index, b.time, b.sigma, b.tau);
    });
  }

  std::size_t size() const { return m_minima.size(); }

  // Those that are strong enough, whatever their fit; all of them have theirs. In no order that matters.
  template <class FT, class Loop>
  std::vector<Feature> above(const Feature_selection& selection, const Rest_shape& shape,
                             const Spatio_temporal_field<FT>& field, double frame_duration, bool is_cyclic,
                             const Loop& loop)
  {
    constexpr std::size_t at_once = 256;
    double strongest = 0;
    std::size_t end = 0;
    const auto least = [&] { return selection.least_strength(strongest); };
    while (end < m_minima.size() && m_minima[end].amplitude >= least()) {
      const std::size_t first = end;
      end = (std::min)(m_minima.size(), end + at_once);
      measure(end, shape, field, frame_duration, is_cyclic, loop);
      for (std::size_t i = first; i < end; ++i) strongest = (std::max)(strongest, m_minima[i].strength);
    }
    std::vector<Feature> result(m_minima.begin(), m_minima.begin() + std::ptrdiff_t(end));
    result.erase(std::remove_if(result.begin(), result.end(), [&](const Feature& f) { return !(f.strength >= least()); }),
                 result.end());
    return result;
  }

private:
  // The fits of the first `end` minima.
  template <class FT, class Loop>
  void measure(std::size_t end, const Rest_shape& shape, const Spatio_temporal_field<FT>& field, double frame_duration,
               bool is_cyclic, const Loop& loop)
  {
    if (end <= m_measured) return;
    const std::vector<double> areas = vertex_areas(shape);
    constexpr std::size_t minima_per_task = 4;
    const std::size_t first = m_measured, count = end - first;
    Thread_local<Feature_fit_measure<FT>> measures;
    loop((count + minima_per_task - 1) / minima_per_task, [&](std::size_t task) {
      auto& fit = measures.get(
          [&] { return std::make_unique<Feature_fit_measure<FT>>(shape, areas, field, frame_duration, is_cyclic); });
      for (std::size_t i = first + task * minima_per_task; i < (std::min)(end, first + (task + 1) * minima_per_task); ++i) {
        Feature& f = m_minima[i];
        f.fit = fit(f).fit;
        f.strength = f.amplitude * m_sigma_fade(f.sigma) * m_tau_fade(f.tau);
        if (m_weighs_by_fit) f.strength *= (std::max)(0., f.fit);
      }
    });
    m_measured = end;
  }

  std::vector<Feature> m_minima; // by amplitude, the largest first
  std::size_t m_measured = 0;    // how many of them have their fit
  bool m_weighs_by_fit = true;
  Scale_fade m_sigma_fade, m_tau_fade;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_INTERNAL_FITTED_MINIMA_H
