// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_PAINTING_SCORES_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_PAINTING_SCORES_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Evaluation/Random_numbers.h>
#include <CGAL/Animated_mesh_features/Evaluation/map_scores.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

Scores maps against what several people painted, and the people against one another.
*/
class Painting_scores
{
public:
  typedef Spatio_temporal_field<float> Map; ///< `N x F`; of a painter 1 where it is painted, 0 elsewhere

  /*!
  takes over the paintings.
  \param painted a map for each painter, all of the same size; at least one.
  \param areas `N`, see `vertex_areas()`; is kept by reference.
  \throw Option_error if there are no painters.
  */
  Painting_scores(std::vector<Map> painted, const std::vector<double>& areas)
    : m_painted(std::move(painted))
    , m_areas(&areas)
  {
    if (m_painted.empty()) throw Option_error("there is no painting to compare with");
  }

  /// the number of painters.
  std::size_t number_of_painters() const { return m_painted.size(); }

  /// compares a map with each painter's. The mean of all is the score of the map, and they are the sample behind it.
  /// \throw Option_error, Input_error as `map_scores()` does.
  std::vector<Map_scores> operator()(const Map& map) const
  {
    std::vector<Map_scores> scores;
    for (const Map& painted : m_painted) scores.push_back(map_scores(map, painted, *m_areas));
    return scores;
  }

  /// the same, the mean over all painters.
  Map_scores mean(const Map& map) const { return mean_of((*this)(map)); }

  /*!
  computes what the mean painting of one half of the painters scores against each of the other half: what can be expected
  of a map, since people do not agree either.
  \param splits how many times the painters are parted at random; each half is compared with the other.
  \param seed the same seed gives the same splits.
  \throw Option_error if there are less than two painters, or no splits.
  */
  Map_scores split_half(std::size_t splits = 20, std::uint64_t seed = 0) const
  {
    const std::size_t n = m_painted.size();
    if (n < 2 || splits == 0) throw Option_error("painters can be compared with one another if there are two or more");
    Random_numbers random(seed);
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t(0));
    if (n == 2) splits = 1; // there is one only
    std::vector<Map_scores> scores;
    for (std::size_t s = 0; s < splits; ++s) {
      for (std::size_t i = n - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
      const auto middle = order.begin() + std::ptrdiff_t(n / 2);
      const std::vector<std::size_t> first(order.begin(), middle), second(middle, order.end());
      compare(first, second, scores);
      compare(second, first, scores);
    }
    return mean_of(scores);
  }

  /// the mean of scores, at least one.
  static Map_scores mean_of(const std::vector<Map_scores>& scores)
  {
    Map_scores mean;
    for (const Map_scores& s : scores) mean += s;
    mean *= 1. / double(scores.size());
    return mean;
  }

private:
  void compare(const std::vector<std::size_t>& some, const std::vector<std::size_t>& others,
               std::vector<Map_scores>& scores) const
  {
    Map sum(m_painted.front().number_of_rows(), m_painted.front().number_of_frames());
    for (std::size_t i : some)
      for (std::size_t v = 0; v < sum.number_of_rows(); ++v)
        for (std::size_t m = 0; m < sum.number_of_frames(); ++m) sum(v, m) += m_painted[i](v, m);
    for (std::size_t i : others) scores.push_back(map_scores(sum, m_painted[i], *m_areas));
  }

  std::vector<Map> m_painted;
  const std::vector<double>* m_areas;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_PAINTING_SCORES_H
