// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_PATH_LENGTHS_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_PATH_LENGTHS_H

#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Source_pack.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Surface_patch.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Lengths of the shortest paths along the edges of a patch, from a pack of sources at a time: edges are relaxed until
// nothing changes, for all sources at once and without a queue. If the sources are close together and vertices come
// roughly in the order of their distance from them, each is relaxed three or four times. The lengths are those of
// Dijkstra's algorithm, to the bit, as both are the least among the sums from the source outwards.
class Path_lengths
{
public:
  typedef Rest_shape::Index Index;
  typedef Source_pack::Array Array;

  // The length where no path leads: finite, since an infinite one would not equal itself in differences.
  static constexpr double far = 1e300;

  // Considers paths through the vertices of `order`, among which the sources must be.
  void run(const Surface_patch& patch, const std::vector<Index>& sources, const std::vector<Index>& order)
  {
    m_length.assign(patch.number_of_vertices(), Array::Constant(far));
    m_changed.assign(patch.number_of_vertices(), 0);
    m_relaxed.assign(patch.number_of_vertices(), 0);
    m_now = 1;
    for (std::size_t l = 0; l < sources.size(); ++l) {
      m_length[sources[l]][l] = 0;
      m_changed[sources[l]] = m_now;
    }
    bool changes = true;
    for (bool outwards = true; changes; outwards = !outwards) {
      changes = false;
      for (std::size_t i = 0; i < order.size(); ++i)
        changes |= relax(patch, outwards ? order[i] : order[order.size() - 1 - i]);
    }
  }

  const Array& length(std::size_t v) const { return m_length[v]; }

private:
  // Returns whether a path to v has become shorter.
  bool relax(const Surface_patch& patch, Index v)
  {
    bool news = false;
    for (const Surface_patch::Neighbour& w : patch.neighbours(v)) news |= m_changed[w.vertex] > m_relaxed[v];
    if (!news) return false;
    m_relaxed[v] = m_now;
    Array best = m_length[v];
    for (const Surface_patch::Neighbour& w : patch.neighbours(v)) best = best.min(m_length[w.vertex] + w.length);
    if (!((m_length[v] - best).maxCoeff() > 0)) return false;
    m_length[v] = best;
    m_changed[v] = ++m_now;
    return true;
  }

  Source_pack::Rows m_length;
  std::vector<std::size_t> m_changed, m_relaxed; // when, in changes since the beginning
  std::size_t m_now = 0;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_PATH_LENGTHS_H
