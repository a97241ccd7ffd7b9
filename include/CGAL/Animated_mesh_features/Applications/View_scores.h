// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VIEW_SCORES_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VIEW_SCORES_H

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesViews

How well directions show an animation, as `score_views()` found it: for `D` directions and `I` items `D I` bytes.
*/
class View_scores
{
public:
  /// no directions yet.
  /// \param frames the frames that are looked at, ascending.
  /// \param first_items where the items of each frame begin, and where the last ones end: one more than there are frames.
  /// \param weights of the items, not negative.
  View_scores(std::vector<std::size_t> frames, std::vector<std::size_t> first_items, std::vector<double> weights)
    : m_frames(std::move(frames))
    , m_first_items(std::move(first_items))
    , m_weights(std::move(weights))
  {
    for (double w : m_weights) m_sum += w;
  }

  /// the directions, unit vectors from the body to the camera.
  const std::vector<Eigen::Vector3d>& directions() const { return m_directions; }

  /// the frames that were looked at, ascending.
  const std::vector<std::size_t>& frames() const { return m_frames; }

  /// what a direction shows of all that there is to be seen, from 0 to 1; 0 if there is nothing.
  double score(std::size_t direction) const { return m_scores[direction]; }

  /// what a direction shows in the `k`-th of the frames, as a part of all that there is to be seen in all frames.
  double score(std::size_t direction, std::size_t k) const { return m_frame_scores[direction * m_frames.size() + k]; }

  /// what there is to be seen in the `k`-th frame, as a part of that in all frames.
  double weight(std::size_t k) const
  {
    double sum = 0;
    for (std::size_t i = m_first_items[k]; i < m_first_items[k + 1]; ++i) sum += m_weights[i];
    return m_sum > 0 ? sum / m_sum : 0;
  }

  /// what several directions show together, of each item what the one shows that shows most of it.
  double covered(const std::vector<std::size_t>& directions) const
  {
    std::vector<std::uint8_t> seen(m_weights.size(), 0);
    for (std::size_t d : directions) add_seen(d, seen);
    return worth(seen);
  }

  /// what all directions show together: the most that any choice of them can, less than 1 if something is hidden from all
  /// of them. `O(D I)` time.
  double covered_by_all() const
  {
    std::vector<std::uint8_t> seen(m_weights.size(), 0);
    for (std::size_t d = 0; d < m_directions.size(); ++d) add_seen(d, seen);
    return worth(seen);
  }

  /// the rank of the best direction, the first of equal ones; of those of which `is_allowed(direction)` says so.
  /// \returns `directions().size()` if none is allowed.
  template <class Predicate>
  std::size_t best(const Predicate& is_allowed) const
  {
    std::size_t result = m_directions.size();
    for (std::size_t d = 0; d < m_directions.size(); ++d)
      if (is_allowed(m_directions[d]) && (result == m_directions.size() || m_scores[d] > m_scores[result])) result = d;
    return result;
  }

  /// \cond SKIP_IN_MANUAL
  // For score_views() and covering_views(): what is seen of an item is kept in 255ths.
  std::size_t first_item(std::size_t k) const { return m_first_items[k]; }

  void add_directions(const std::vector<Eigen::Vector3d>& directions)
  {
    m_directions.insert(m_directions.end(), directions.begin(), directions.end());
    m_scores.resize(m_directions.size(), 0);
    m_frame_scores.resize(m_directions.size() * m_frames.size(), 0);
    m_seen.resize(m_directions.size() * m_weights.size(), 0);
  }

  void set_seen(std::size_t direction, std::size_t k, const float* seen)
  {
    double sum = 0;
    for (std::size_t i = m_first_items[k]; i < m_first_items[k + 1]; ++i, ++seen) {
      sum += m_weights[i] * double(*seen);
      m_seen[direction * m_weights.size() + i] = std::uint8_t((std::min)(1.f, (std::max)(0.f, *seen)) * 255 + 0.5f);
    }
    m_frame_scores[direction * m_frames.size() + k] = m_sum > 0 ? sum / m_sum : 0;
  }

  void sum_up()
  {
    for (std::size_t d = 0; d < m_directions.size(); ++d) {
      m_scores[d] = 0;
      for (std::size_t k = 0; k < m_frames.size(); ++k) m_scores[d] += score(d, k);
    }
  }

  std::size_t number_of_items() const { return m_weights.size(); }

  void add_seen(std::size_t direction, std::vector<std::uint8_t>& seen) const
  {
    const std::uint8_t* const row = m_seen.data() + direction * m_weights.size();
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = (std::max)(seen[i], row[i]);
  }

  double worth(const std::vector<std::uint8_t>& seen) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) sum += m_weights[i] * seen[i];
    return m_sum > 0 ? sum / (255 * m_sum) : 0;
  }
  /// \endcond

private:
  std::vector<Eigen::Vector3d> m_directions;
  std::vector<std::size_t> m_frames, m_first_items;
  std::vector<double> m_weights;
  double m_sum = 0;
  std::vector<double> m_scores, m_frame_scores;
  std::vector<std::uint8_t> m_seen;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VIEW_SCORES_H
