// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_ACTIVITY_SUMS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_ACTIVITY_SUMS_H

#include <CGAL/Animated_mesh_features/Applications/Activity.h>
#include <CGAL/Animated_mesh_features/Applications/internal/find_cycle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The sums over vertices that an activity is made of. Of a loop the first sample follows the last one.
class Activity_sums
{
public:
  // Centres of classes of eccentricity: from the middle of a body to the tips of its limbs.
  static constexpr std::array<double, 6> centres = {{0.7, 0.85, 1, 1.2, 1.4, 1.6}};

  Activity_sums(std::size_t samples, const Activity_options& o, bool has_places)
    : m_samples(samples)
    , m_lags(o.lags)
    , m_lag((std::max)(std::size_t(1), std::size_t(std::lround(o.lag_step / o.sample_duration))))
    , m_sample_duration(o.sample_duration)
    , m_is_cyclic(o.is_cyclic)
    , m_classes(has_places ? centres.size() : 0)
    , m_step((samples + coarse - 1) / coarse)
    , m_mean(samples, 0)
    , m_recurrence(samples * o.lags, 0)
    , m_places(samples * m_classes, 0)
    , m_profile(o.is_cyclic ? m_samples / m_step : (samples - 1) / m_step + 1, 0)
  {}

  std::size_t samples() const { return m_samples; }

  // A vertex: its row of the field, its area, and how far out on the body it is.
  template <class FT>
  void add(const FT* row, std::size_t frames, double area, double eccentricity)
  {
    m_row.resize(m_samples);
    for (std::size_t t = 0; t < m_samples; ++t) {
      const double at = m_is_cyclic ? double(t) / double(m_samples) * double(frames)
                                    : double(t) / double(m_samples - 1) * double(frames - 1);
      const std::size_t f = (std::min)(std::size_t(at), m_is_cyclic ? frames - 1 : frames - 2);
      const std::size_t next = f + 1 < frames ? f + 1 : 0;
      m_row[t] = double(row[f]) + (at - double(f)) * (double(row[next]) - double(row[f]));
    }
    m_area += area;
    double sum = 0, squares = 0;
    for (double x : m_row) {
      sum += x;
      squares += x * x;
    }
    m_variance += area * (squares / double(m_samples) - sum * sum / double(m_samples) / double(m_samples));
    for (std::size_t t = 0; t < m_samples; ++t) m_mean[t] += area * m_row[t];
    for (std::size_t l = 0; l < m_lags; ++l)
      for (std::size_t t = 0; t < m_samples; ++t) {
        const double d = m_row[t] - m_row[later(t, (l + 1) * m_lag)];
        m_recurrence[l * m_samples + t] += area * d * d;
      }
    if (m_classes > 0) add_places(area, eccentricity);
    for (std::size_t k = 1; k < m_profile.size(); ++k) {
      const std::size_t times = m_is_cyclic ? m_profile.size() : m_profile.size() - k;
      double differences = 0;
      for (std::size_t t = 0; t < times; ++t) {
        const double d = m_row[t * m_step] - m_row[later(t * m_step, k * m_step)];
        differences += d * d;
      }
      m_profile[k] += area * differences / double(times);
    }
  }

  void add(const Activity_sums& other)
  {
    m_area += other.m_area;
    m_variance += other.m_variance;
    const auto sum = [](std::vector<double>& to, const std::vector<double>& from) {
      for (std::size_t i = 0; i < to.size(); ++i) to[i] += from[i];
    };
    sum(m_mean, other.m_mean);
    sum(m_recurrence, other.m_recurrence);
    sum(m_places, other.m_places);
    sum(m_profile, other.m_profile);
  }

  Activity activity() const
  {
    Activity a;
    a.samples = m_samples;
    a.sample_duration = m_sample_duration;
    a.lags = m_lags;
    a.classes = m_classes;
    a.is_cyclic = m_is_cyclic;
    a.mean.assign(m_samples, 0);
    a.recurrence.assign(m_samples * 2 * m_lags, 0);
    a.places.assign(m_samples * m_classes, 0);
    // A field that does not change has no recurrence but rounding errors.
    double squares = 0;
    for (double x : m_mean) squares += x * x;
    a.level = m_area > 0 ? std::sqrt(squares / double(m_samples)) / m_area : 0;
    if (!(a.level > 0)) return a;
    for (std::size_t t = 0; t < m_samples; ++t) a.mean[t] = float(m_mean[t] / m_area / a.level);
    const double least = 1e-12 * a.level * a.level * m_area;
    if (m_variance > least) {
      // the mean square of all pairs of times is the doubled variance
      const double unit = 2 * m_variance * 2 * double(m_lags);
      for (std::size_t t = 0; t < m_samples; ++t)
        for (std::size_t l = 0; l < m_lags; ++l) {
          const std::size_t lag = (l + 1) * m_lag;
          // at the beginning the first sample stands for those before it
          const double after = m_recurrence[l * m_samples + t];
          const double before = m_is_cyclic
                                    ? m_recurrence[l * m_samples + (t + m_samples - lag % m_samples) % m_samples]
                                : t >= lag ? m_recurrence[l * m_samples + t - lag]
                                           : from_first(t);
          a.recurrence[t * 2 * m_lags + l] = float(std::sqrt(after / unit));
          a.recurrence[t * 2 * m_lags + m_lags + l] = float(std::sqrt(before / unit));
        }
      std::vector<double> profile = m_profile;
      for (double& x : profile) x /= 2 * m_variance;
      a.cycle = find_cycle(profile, double(m_step) * m_sample_duration, m_is_cyclic ? 0 : 1);
      if (m_is_cyclic) a.cycle = cycle_of_loop(a.cycle, a.duration());
    }
    double places = 0;
    for (double x : m_places) places += x * x;
    if (places > 0)
      for (std::size_t i = 0; i < m_places.size(); ++i)
        a.places[i] = float(m_places[i] / std::sqrt(places / double(m_samples)));
    return a;
  }

private:
  static constexpr std::size_t coarse = 128; // samples for the search for a cycle

  // That of a number of samples later: of a loop around its end, else the last one at most.
  std::size_t later(std::size_t t, std::size_t lag) const
  {
    return m_is_cyclic ? (t + lag) % m_samples : (std::min)(t + lag, m_samples - 1);
  }

  // The difference from the first sample is among the differences to later ones where a lag fits; else it is that of
  // the nearest lag that does.
  double from_first(std::size_t t) const
  {
    const std::size_t l = t / m_lag;
    return l == 0 ? 0 : m_recurrence[(l - 1) * m_samples + t - l * m_lag];
  }

  void add_places(double area, double eccentricity)
  {
    std::size_t c = 0;
    while (c + 2 < centres.size() && centres[c + 1] <= eccentricity) ++c;
    const double fraction = (std::min)((std::max)((eccentricity - centres[c]) / (centres[c + 1] - centres[c]), 0.), 1.);
    for (std::size_t t = 0; t < m_samples; ++t) {
      m_places[t * m_classes + c] += area * (1 - fraction) * m_row[t];
      m_places[t * m_classes + c + 1] += area * fraction * m_row[t];
    }
  }

  std::size_t m_samples, m_lags, m_lag; // the lag in samples
  double m_sample_duration;
  bool m_is_cyclic;
  std::size_t m_classes, m_step;
  double m_area = 0, m_variance = 0;
  std::vector<double> m_mean, m_recurrence, m_places; // m_recurrence: squares, lag by lag
  std::vector<double> m_profile;                      // squares of differences by lag, coarser
  std::vector<double> m_row;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_ACTIVITY_SUMS_H
