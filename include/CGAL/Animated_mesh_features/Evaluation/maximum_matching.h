// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_MAXIMUM_MATCHING_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_MAXIMUM_MATCHING_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

Which right element each left element is paired with, and the other way round.
*/
struct Bipartite_matching
{
  /// stands for an element without a partner.
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::vector<std::size_t> right_of_left; ///< for each left element its partner, or `none`
  std::vector<std::size_t> left_of_right; ///< for each right element its partner, or `none`
  std::size_t size = 0;                   ///< the number of pairs
};

namespace internal {

// J. E. Hopcroft, R. M. Karp, An n^(5/2) algorithm for maximum matchings in bipartite graphs, SIAM J. Comput. 2, 1973.
class Hopcroft_karp
{
  static constexpr std::size_t none = Bipartite_matching::none;

public:
  Hopcroft_karp(const Compressed_rows& partners, std::size_t number_of_right)
    : m_partners(&partners)
    , m_level(partners.size())
    , m_next(partners.size())
  {
    m_matching.right_of_left.assign(partners.size(), none);
    m_matching.left_of_right.assign(number_of_right, none);
  }

  Bipartite_matching operator()()
  {
    while (find_levels())
      for (std::size_t left = 0; left < m_level.size(); ++left)
        if (m_matching.right_of_left[left] == none && augment(left)) ++m_matching.size;
    return std::move(m_matching);
  }

private:
  // Breadth first from all lefts without a partner; whether a right without one is reached.
  bool find_levels()
  {
    m_queue.clear();
    for (std::size_t left = 0; left < m_level.size(); ++left) {
      m_next[left] = 0;
      m_level[left] = m_matching.right_of_left[left] == none ? 0 : none;
      if (m_level[left] == 0) m_queue.push_back(left);
    }
    bool is_reached = false;
    for (std::size_t i = 0; i < m_queue.size(); ++i)
      for (Compressed_rows::Index right : (*m_partners)[m_queue[i]]) {
        const std::size_t left = m_matching.left_of_right[right];
        if (left == none) {
          is_reached = true;
        } else if (m_level[left] == none) {
          m_level[left] = m_level[m_queue[i]] + 1;
          m_queue.push_back(left);
        }
      }
    return is_reached;
  }

  // Depth first along the levels, without recursion: a path may be as long as there are elements.
  bool augment(std::size_t root)
  {
    m_path.assign(1, root);
    while (!m_path.empty()) {
      const std::size_t left = m_path.back();
      const Compressed_rows::Row row = (*m_partners)[left];
      if (m_next[left] == std::size_t(row.size())) {
        m_level[left] = none; // leads nowhere
        m_path.pop_back();
        if (!m_path.empty()) ++m_next[m_path.back()];
        continue;
      }
      const std::size_t right = row[std::ptrdiff_t(m_next[left])], onwards = m_matching.left_of_right[right];
      if (onwards == none) {
        pair_along_path();
        return true;
      }
      if (m_level[onwards] == m_level[left] + 1)
        m_path.push_back(onwards);
      else
        ++m_next[left];
    }
    return false;
  }

  // Each left of the path gets the right at which it looks; the last of these had no partner.
  void pair_along_path()
  {
    for (std::size_t left : m_path) {
      const std::size_t right = (*m_partners)[left][std::ptrdiff_t(m_next[left])];
      m_matching.right_of_left[left] = right;
      m_matching.left_of_right[right] = left;
      m_level[left] = none; // paths of one round have no element in common
    }
  }

  const Compressed_rows* m_partners;
  Bipartite_matching m_matching;
  std::vector<std::size_t> m_level, m_next, m_queue, m_path;
};

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

pairs as many elements as can be: of two sets, each element with one partner at most, along given edges. Where a pair
either counts or does not, this is what an optimal assignment comes to. Of several largest matchings one is chosen that
depends on the order of the elements only.

By the algorithm of Hopcroft and Karp, \f$O(E \sqrt N)\f$ for `E` edges and `N` elements.

\param partners for each left element the right ones with which it can be paired, below `number_of_right`.
\param number_of_right the number of right elements.
*/
inline Bipartite_matching maximum_matching(const Compressed_rows& partners, std::size_t number_of_right)
{
  return internal::Hopcroft_karp(partners, number_of_right)();
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_MAXIMUM_MATCHING_H
