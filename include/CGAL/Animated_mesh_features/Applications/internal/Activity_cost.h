// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_ACTIVITY_COST_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_ACTIVITY_COST_H

#include <CGAL/Animated_mesh_features/Applications/Activity.h>
#include <CGAL/Animated_mesh_features/Applications/Alignment_options.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Vector_sequence.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// How different two samples of two activities are: the Euclidean distance of their vectors, each group times its
// weight.
class Activity_cost
{
public:
  Activity_cost(const Activity& a, const Activity& b, const Alignment_options& o)
    : m_recurrence(2 * a.lags)
    , m_width(1 + 2 * a.lags + (a.classes == b.classes && o.place_weight > 0 ? a.classes : 0))
  {
    if (std::abs(a.sample_duration - b.sample_duration) > 1e-9 * a.sample_duration || a.lags != b.lags)
      throw Option_error("two activities have different times between samples, or different lags");
    if (a.samples == 0 || b.samples == 0) throw Option_error("an activity has no samples");
    const bool has_places = a.classes == b.classes && a.classes > 0 && o.place_weight > 0;
    m_has_instants = has_places || o.mean_weight > 0;
    m_wraps_a = a.is_cyclic;
    m_wraps_b = b.is_cyclic;
    m_a = vectors(a, o, has_places);
    m_b = vectors(b, o, has_places);
    m_norm = norm(m_a) + norm(m_b);
  }

  double operator()(std::size_t i, std::size_t j) const
  {
    const float *x = &m_a[i * m_width], *y = &m_b[j * m_width];
    float squares = 0;
    for (std::size_t k = 0; k < m_width; ++k) squares += (x[k] - y[k]) * (x[k] - y[k]);
    return std::sqrt(double(squares));
  }

  // The same between samples, too: the least of one side's sample and the other side's half way to the next ones, where
  // vectors are linear. A loop has no beginning at which samples of two of them would coincide.
  double between_samples(std::size_t i, std::size_t j) const
  {
    return std::sqrt((std::min)(least_square(m_a, i, m_b, j, m_wraps_b), least_square(m_b, j, m_a, i, m_wraps_a)));
  }

  // Without what compares a sample with others before and after, if there is anything else: that is changed by a warp.
  Vector_sequence instants_of_a() const { return instants(m_a); }
  Vector_sequence instants_of_b() const { return instants(m_b); }

  // how many numbers each group of these has
  std::vector<std::size_t> groups_of_instants() const
  {
    if (!m_has_instants) return {1, m_recurrence};
    return m_width > 1 + m_recurrence ? std::vector<std::size_t>{1, m_width - 1 - m_recurrence}
                                      : std::vector<std::size_t>{1};
  }

  // the mean length of the vectors of both
  double mean_norm() const { return m_norm / double((m_a.size() + m_b.size()) / m_width); }

  // A sum over all samples relative to the largest that there could be: that of motions that are nowhere alike.
  double relative(double sum) const { return m_norm > 0 ? (std::min)(sum / m_norm, 1.) : 0; }

private:
  // of sample i of x to those from half a sample before to half a sample after j of y.
  double least_square(const std::vector<float>& x, std::size_t i, const std::vector<float>& y, std::size_t j,
                      bool wraps) const
  {
    const std::size_t size = y.size() / m_width;
    const std::size_t before = j > 0 ? j - 1 : wraps ? size - 1 : 0, after = j + 1 < size ? j + 1 : wraps ? 0 : j;
    const float *p = &x[i * m_width], *q = &y[j * m_width];
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t other : {before, after}) {
      const float* r = &y[other * m_width];
      double pp = 0, pe = 0, ee = 0; // of p - q and half of the step e from q to r
      for (std::size_t k = 0; k < m_width; ++k) {
        const double d = double(p[k]) - double(q[k]), e = (double(r[k]) - double(q[k])) / 2;
        pp += d * d;
        pe += d * e;
        ee += e * e;
      }
      const double along = ee > 0 ? (std::min)((std::max)(pe / ee, 0.), 1.) : 0;
      least = (std::min)(least, (std::max)(pp - 2 * along * pe + along * along * ee, 0.));
    }
    return least;
  }

  Vector_sequence instants(const std::vector<float>& vectors) const
  {
    if (!m_has_instants) return Vector_sequence(vectors, m_width);
    std::vector<float> result;
    for (std::size_t begin = 0; begin < vectors.size(); begin += m_width)
      for (std::size_t k = 0; k < m_width; ++k)
        if (k == 0 || k > m_recurrence) result.push_back(vectors[begin + k]);
    return Vector_sequence(result, m_width - m_recurrence);
  }

  std::vector<float> vectors(const Activity& a, const Alignment_options& o, bool has_places) const
  {
    std::vector<float> result;
    result.reserve(a.samples * m_width);
    const auto append = [&](double weight, const std::vector<float>& group, std::size_t width, std::size_t t) {
      const float root = float(std::sqrt(weight));
      for (std::size_t k = 0; k < width; ++k) result.push_back(root * group[t * width + k]);
    };
    const double recurrence_weight =
        has_places ? o.recurrence_weight : (std::max)(o.recurrence_weight, o.recurrence_without_places);
    const std::vector<float> mean = o.without_least_mean ? without_least(a.mean) : a.mean;
    for (std::size_t t = 0; t < a.samples; ++t) {
      append(o.mean_weight, mean, 1, t);
      append(recurrence_weight, a.recurrence, 2 * a.lags, t);
      if (has_places) append(o.place_weight, a.places, a.classes, t);
    }
    return result;
  }

  // In squares, as noise adds; again with a root mean square of 1.
  static std::vector<float> without_least(const std::vector<float>& mean)
  {
    const double least = *std::min_element(mean.begin(), mean.end());
    std::vector<double> above;
    double squares = 0;
    for (float x : mean) {
      above.push_back(double(x) * double(x) - least * least);
      squares += above.back() / double(mean.size());
    }
    std::vector<float> result(mean.size(), 0);
    if (!(squares > 1e-6)) return result; // a mean that does not change, up to the precision of its numbers
    for (std::size_t t = 0; t < mean.size(); ++t) result[t] = float(std::sqrt(above[t] / squares));
    return result;
  }

  double norm(const std::vector<float>& vectors) const
  {
    double sum = 0;
    for (std::size_t t = 0; t * m_width < vectors.size(); ++t) {
      double squares = 0;
      for (std::size_t k = 0; k < m_width; ++k)
        squares += double(vectors[t * m_width + k]) * double(vectors[t * m_width + k]);
      sum += std::sqrt(squares);
    }
    return sum;
  }

  std::size_t m_recurrence, m_width; // numbers of a vector: the mean, the recurrence, and places if there are any
  bool m_has_instants = false, m_wraps_a = false, m_wraps_b = false;
  std::vector<float> m_a, m_b;
  double m_norm = 0;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_ACTIVITY_COST_H
