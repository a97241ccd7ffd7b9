// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_COINCIDENT_VERTICES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_COINCIDENT_VERTICES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesModels

Finds the vertices that are at the same place in every frame, bit for bit (but that 0 and -0 are the same).

Frames are added one after the other, in any order; each splits the classes of vertices that were together so far, and
vertices that are alone are not looked at any more. Expected time linear in the number of coordinates, by hashing.
*/
class Coincident_vertices
{
public:
  /// a position for each vertex.
  typedef std::vector<std::array<double, 3>> Points;

  /// before the first frame all vertices are together.
  explicit Coincident_vertices(std::size_t number_of_vertices)
    : m_first_of_class(number_of_vertices, 0)
    , m_candidates(number_of_vertices)
  {
    std::iota(m_candidates.begin(), m_candidates.end(), std::size_t(0));
  }

  /// takes apart the vertices that are not together in this frame.
  void add_frame(const Points& points)
  {
    add_positions([&](std::size_t v) { return points[v]; });
  }

  /// the same for positions that are kept in another way: `position(v)` is an `std::array<double, 3>`; called for vertices
  /// only that are not alone yet.
  template <class Position>
  void add_positions(const Position& position)
  {
    std::unordered_map<Place, std::size_t, Hash> first; // of the vertices that are still together
    first.reserve(m_candidates.size());
    std::vector<char> is_alone(m_first_of_class.size(), 1);
    for (std::size_t v : m_candidates) {
      Place place;
      place[0] = m_first_of_class[v];
      const std::array<double, 3> p = position(v);
      for (std::size_t k = 0; k < 3; ++k) place[k + 1] = bits(p[k]);
      const auto result = first.emplace(place, v);
      m_first_of_class[v] = result.first->second;
      if (!result.second) is_alone[v] = is_alone[result.first->second] = 0;
    }
    std::size_t n = 0;
    for (std::size_t v : m_candidates)
      if (!is_alone[v]) m_candidates[n++] = v;
    m_candidates.resize(n);
  }

  /// whether no two vertices are left that were together in all frames: further frames change nothing.
  bool all_apart() const { return m_candidates.empty(); }

  /// for each vertex the first one that was at its place in all frames: itself, if there is none before.
  const std::vector<std::size_t>& first_of_class() const { return m_first_of_class; }

private:
  typedef std::array<std::uint64_t, 4> Place; // class and coordinates

  struct Hash
  {
    std::size_t operator()(const Place& place) const
    {
      std::uint64_t h = 0;
      for (std::uint64_t x : place) {
        h = (h ^ x) * 0x9e3779b97f4a7c15u; // 2^64 over the golden ratio
        h ^= h >> 32;
      }
      return std::size_t(h);
    }
  };

  static std::uint64_t bits(double x)
  {
    if (x == 0) x = 0; // as -0 is, too
    std::uint64_t u;
    std::memcpy(&u, &x, sizeof(u));
    return u;
  }

  std::vector<std::size_t> m_first_of_class;
  std::vector<std::size_t> m_candidates; // ascending: those that may share their place
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_COINCIDENT_VERTICES_H
