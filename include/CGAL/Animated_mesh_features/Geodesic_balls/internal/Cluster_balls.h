// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_CLUSTER_BALLS_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_CLUSTER_BALLS_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Source_pack.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The balls of the vertices of a cluster. They have most of their vertices in common: each vertex is stored once, with
// a bit for each ball, in a quarter of the memory of the balls one by one or less.
class Cluster_balls
{
public:
  typedef Compressed_rows::Index Index;
  typedef std::uint8_t Mask; // a bit for each source of a pack
  static constexpr std::size_t pack_size = Source_pack::size;
  static_assert(pack_size == 8, "a mask has a bit for each source of a pack");

  Cluster_balls() = default;

  // sources: the centres, a group for each pack of them. masks: for each group, those of all vertices, which
  // ascend.
  Cluster_balls(const std::vector<Index>& sources, const std::vector<Index>& vertices, const std::vector<Mask>& masks)
    : m_sources(sources)
  {
    const std::size_t n = vertices.size();
    std::vector<Mask> in_any(n, 0);
    for (std::size_t i = 0; i < masks.size(); ++i) in_any[i % n] |= masks[i];
    const std::size_t kept = n - std::size_t(std::count(in_any.begin(), in_any.end(), Mask(0)));
    m_vertices.reserve(kept);
    for (std::size_t v = 0; v < n; ++v)
      if (in_any[v]) m_vertices.push_back(vertices[v]);
    m_masks.reserve(kept * number_of_groups());
    for (std::size_t g = 0; g < number_of_groups(); ++g)
      for (std::size_t v = 0; v < n; ++v)
        if (in_any[v]) m_masks.push_back(masks[g * n + v]);
  }

  // The balls of all vertices.
  static Compressed_rows rows(const std::vector<Cluster_balls>& clusters, std::size_t number_of_vertices)
  {
    std::vector<Index> sizes(number_of_vertices, 0);
    for (const Cluster_balls& c : clusters) c.add_sizes(sizes);
    Compressed_rows result(sizes);
    std::vector<Index>().swap(sizes);
    for (const Cluster_balls& c : clusters) c.fill(result);
    return result;
  }

  std::size_t memory() const
  {
    return (m_sources.capacity() + m_vertices.capacity()) * sizeof(Index) + m_masks.capacity() + sizeof(*this);
  }

private:
  std::size_t number_of_groups() const { return (m_sources.size() + pack_size - 1) / pack_size; }
  std::size_t group_size(std::size_t g) const { return (std::min)(pack_size, m_sources.size() - g * pack_size); }
  const Mask* masks(std::size_t g) const { return m_masks.data() + g * m_vertices.size(); }

  void add_sizes(std::vector<Index>& sizes) const
  {
    for (std::size_t g = 0; g < number_of_groups(); ++g) {
      std::array<Index, pack_size> size = {};
      for (std::size_t v = 0; v < m_vertices.size(); ++v)
        for (std::size_t l = 0; l < pack_size; ++l) size[l] += masks(g)[v] >> l & 1;
      for (std::size_t l = 0; l < group_size(g); ++l) sizes[m_sources[g * pack_size + l]] = size[l];
    }
  }

  void fill(Compressed_rows& rows) const
  {
    // Written whether it belongs to the ball or not, and overwritten if it does not: branches would be mispredicted.
    std::vector<Index> ball(m_vertices.size() + 1);
    for (std::size_t g = 0; g < number_of_groups(); ++g)
      for (std::size_t l = 0; l < group_size(g); ++l) {
        std::size_t size = 0;
        for (std::size_t v = 0; v < m_vertices.size(); ++v) {
          ball[size] = m_vertices[v];
          size += masks(g)[v] >> l & 1;
        }
        std::copy_n(ball.begin(), size, rows.row(m_sources[g * pack_size + l]));
      }
  }

  std::vector<Index> m_sources, m_vertices;
  std::vector<Mask> m_masks;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_CLUSTER_BALLS_H
