// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_INTERNAL_CONSISTENT_PAIRS_H
#define CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_INTERNAL_CONSISTENT_PAIRS_H

#include <CGAL/Animated_mesh_features/Descriptors/Described_features.h>
#include <CGAL/Animated_mesh_features/Descriptors/Matching_options.h>
#include <CGAL/Animated_mesh_features/Descriptors/internal/Candidate_pairs.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Of candidate pairs those that agree with one another, see match_features().
class Consistent_pairs
{
public:
  Consistent_pairs(const Described_features& a, const Described_features& b,
                   const std::vector<Candidate_pair>& candidates, const Matching_options& options)
    : m_a(a)
    , m_b(b)
    , m_candidates(candidates)
    , m_options(options)
  {
    agree();
    find_weights();
  }

  std::vector<Feature_match> matches() const
  {
    const std::size_t seeds = 32;
    std::vector<std::size_t> best;
    double best_score = 0;
    std::vector<std::size_t> order(m_candidates.size());
    for (std::size_t c = 0; c < order.size(); ++c) order[c] = c;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t c, std::size_t d) { return m_weights[c] > m_weights[d]; });
    for (std::size_t i = 0; i < (std::min)(seeds, order.size()); ++i) {
      std::vector<std::size_t> set = grown(order[i]);
      const double score = score_of(set);
      if (score > best_score) {
        best_score = score;
        best.swap(set);
      }
    }
    return matches_of(best);
  }

private:
  typedef Eigen::Vector3d Point;

  double agreement(const Candidate_pair& c, const Candidate_pair& d) const
  {
    if (c.a == d.a || c.b == d.b) return 0;
    const Feature_point &ca = m_a.features[c.a], &da = m_a.features[d.a];
    const Feature_point &cb = m_b.features[c.b], &db = m_b.features[d.b];
    const double x = double(m_a.distances[c.a * m_a.features.size() + d.a]);
    const double y = double(m_b.distances[c.b * m_b.features.size() + d.b]);
    const double in_space = std::abs(x - y) / (m_options.distance_tolerance * (1 + (std::max)(x, y) / 2));
    const auto [late, apart] = times(da.time - ca.time, db.time - cb.time);
    // events are known to within a part of their durations
    const double exact = 0.2 * (ca.tau + da.tau + cb.tau + db.tau) / 2;
    const double in_time = late / (exact + m_options.time_tolerance * apart);
    if (in_space >= 1 || in_time >= 1) return 0;
    return (1 - in_space * in_space) * (1 - in_time * in_time);
  }

  // By how much two differences of times differ, and the larger one. In loops they are known but for ways around; of two
  // loops that are about as long, these are the same.
  std::pair<double, double> times(double s, double t) const
  {
    const double p = m_a.loop, q = m_b.loop;
    if (!(p > 0) && !(q > 0)) return {std::abs(s - t), (std::max)(std::abs(s), std::abs(t))};
    const double shorter = p > 0 && q > 0 ? (std::min)(p, q) : (std::max)(p, q);
    const bool is_one_way = p > 0 && q > 0 && (std::max)(p, q) < 1.5 * shorter;
    const double late = is_one_way ? std::remainder(s / p - t / q, 1) * (p + q) / 2 : std::remainder(s - t, shorter);
    return {std::abs(late), (std::max)(std::abs(std::remainder(s, p > 0 ? p : shorter)),
                                       std::abs(std::remainder(t, q > 0 ? q : shorter)))};
  }

  double likeness(const Candidate_pair& c) const { return std::exp(-c.difference * c.difference / 2); }

  void agree()
  {
    const std::size_t n = m_candidates.size();
    m_agreements.assign(n * n, 0);
    std::vector<double> roots(n);
    for (std::size_t c = 0; c < n; ++c) roots[c] = std::sqrt(likeness(m_candidates[c]));
    for (std::size_t c = 0; c < n; ++c) {
      cancellation_point();
      for (std::size_t d = c + 1; d < n; ++d)
        m_agreements[c * n + d] = m_agreements[d * n + c] =
            float(agreement(m_candidates[c], m_candidates[d]) * roots[c] * roots[d]);
    }
  }

  // The principal eigenvector, by power iteration: all entries are positive or zero, so it converges from ones.
  void find_weights()
  {
    const std::size_t n = m_candidates.size();
    const int iterations = 40;
    m_weights.assign(n, 1);
    std::vector<double> next(n);
    for (int k = 0; k < iterations; ++k) {
      cancellation_point();
      double squares = 0;
      for (std::size_t c = 0; c < n; ++c) {
        double sum = 0;
        for (std::size_t d = 0; d < n; ++d) sum += double(m_agreements[c * n + d]) * m_weights[d];
        next[c] = sum;
        squares += sum * sum;
      }
      if (!(squares > 0)) return;
      for (std::size_t c = 0; c < n; ++c) m_weights[c] = next[c] / std::sqrt(squares);
    }
  }

  // From one pair on, always adds the one that agrees most with those that are there, until none agrees well enough.
  std::vector<std::size_t> grown(std::size_t seed) const
  {
    const std::size_t n = m_candidates.size();
    const double least = 0.25; // mean agreement with the set
    std::vector<std::size_t> set;
    std::vector<double> support(n, 0);
    std::vector<char> is_open(n, 1);
    std::size_t next = seed;
    while (next < n) {
      cancellation_point();
      set.push_back(next);
      for (std::size_t c = 0; c < n; ++c) {
        support[c] += double(m_agreements[next * n + c]);
        if (m_candidates[c].a == m_candidates[next].a || m_candidates[c].b == m_candidates[next].b) is_open[c] = 0;
      }
      std::size_t best = n;
      for (std::size_t c = 0; c < n; ++c)
        if (is_open[c] != 0 && support[c] > 0 && (best == n || support[c] > support[best])) best = c;
      next = best < n && support[best] >= least * double(set.size()) ? best : n;
    }
    return set;
  }

  double support_of(std::size_t c, const std::vector<std::size_t>& set) const
  {
    double sum = 0;
    for (std::size_t d : set) sum += double(m_agreements[c * m_candidates.size() + d]);
    return sum;
  }

  double score_of(const std::vector<std::size_t>& set) const
  {
    double sum = 0;
    for (std::size_t c : set) sum += support_of(c, set);
    const double size = double((std::max)(set.size(), std::size_t(1)));
    const double score = sum / size; // as many pairs as possible, that agree as well as possible
    return m_options.use_handedness ? score * (1 + 0.5 * handedness(set)) : score;
  }

  // From -1 to 1: the determinant of the covariance of places in A and B is positive if the orthogonal map that fits
  // best is a rotation, negative for a reflection, and near 0 if places lie in a plane.
  double handedness(const std::vector<std::size_t>& set) const
  {
    Point mean_a(0, 0, 0), mean_b(0, 0, 0);
    const auto place = [](const Feature_point& f) {
      return Point(f.rest_position[0], f.rest_position[1], f.rest_position[2]);
    };
    for (std::size_t c : set) {
      mean_a += place(m_a.features[m_candidates[c].a]);
      mean_b += place(m_b.features[m_candidates[c].b]);
    }
    mean_a /= double((std::max)(set.size(), std::size_t(1)));
    mean_b /= double((std::max)(set.size(), std::size_t(1)));
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (std::size_t c : set)
      covariance += (place(m_a.features[m_candidates[c].a]) - mean_a) *
                    (place(m_b.features[m_candidates[c].b]) - mean_b).transpose();
    const double size = covariance.norm();
    if (!(size > 0)) return 0;
    covariance /= size;
    const double det = covariance.col(0).dot(covariance.col(1).cross(covariance.col(2)));
    const double enough = 0.002; // bodies are flat
    return (std::min)((std::max)(det / enough, -1.), 1.);
  }

  std::vector<Feature_match> matches_of(const std::vector<std::size_t>& set) const
  {
    std::vector<Feature_match> result;
    const double n = double(set.size());
    const double enough = 1 - std::exp(-(n - 1) / 6); // two pairs agree by chance, ten do not
    for (std::size_t c : set) {
      const double agreeing = n > 1 ? support_of(c, set) / (n - 1) : 0;
      result.push_back({m_candidates[c].a, m_candidates[c].b, enough * agreeing, m_candidates[c].difference});
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Feature_match& x, const Feature_match& y) { return x.confidence > y.confidence; });
    return result;
  }

  const Described_features &m_a, &m_b;
  const std::vector<Candidate_pair>& m_candidates;
  const Matching_options& m_options;
  std::vector<float> m_agreements;
  std::vector<double> m_weights;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_INTERNAL_CONSISTENT_PAIRS_H
