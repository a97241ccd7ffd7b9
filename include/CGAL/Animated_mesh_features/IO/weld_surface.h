// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_WELD_SURFACE_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_WELD_SURFACE_H

#include <CGAL/Animated_mesh_features/IO/internal/Edge_groups.h>
#include <CGAL/Animated_mesh_features/Numerics/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesModels

What `weld_surface()` makes of a file's triangles.
*/
struct Welded_surface
{
  /// those of the file in their order, but for collapsed ones.
  std::vector<std::array<std::size_t, 3>> triangles;

  std::vector<std::size_t> first;         ///< for each vertex where its rows in `file_vertices` begin; one more
  std::vector<std::size_t> file_vertices; ///< those that make vertex `v`, from `first[v]` to `first[v + 1]`, ascending

  /// the number of vertices of the welded surface.
  std::size_t number_of_vertices() const { return first.size() - 1; }

  std::size_t welded_edges = 0;        ///< pairs of borders that became one edge
  std::size_t open_edges = 0;          ///< where borders coincide that cannot be welded into a manifold
  std::size_t collapsed_triangles = 0; ///< that have two corners at the same place in all frames; left out
  std::size_t unused_vertices = 0;     ///< of the file, in no triangle; left out
  std::size_t split_vertices = 0;      ///< of the file, where parts of the surface met in a point only
};

namespace internal {

// The steps of weld_surface(). A corner is three times the number of its triangle plus 0, 1 or 2; it stands for the
// edge to the next corner of its triangle, too.
class Surface_welder
{
public:
  typedef std::vector<std::array<std::size_t, 3>> Triangles;

  Surface_welder(const Triangles& triangles, const std::vector<std::size_t>& place)
    : m_place(place)
    , m_is_apart(place.size(), 0)
  {
    std::vector<char> is_used(place.size(), 0);
    for (const auto& t : triangles) {
      for (std::size_t v : t) is_used[v] = 1;
      if (place[t[0]] == place[t[1]] || place[t[1]] == place[t[2]] || place[t[2]] == place[t[0]]) {
        ++m_result.collapsed_triangles;
        continue;
      }
      m_vertex.insert(m_vertex.end(), t.begin(), t.end());
    }
    m_result.unused_vertices = std::size_t(std::count(is_used.begin(), is_used.end(), 0));
    find_layers();
  }

  Welded_surface operator()()
  {
    do {
      join_triangles();
      number_vertices();
    } while (keep_conflicts_apart());
    list_origins(m_place.size());
    return std::move(m_result);
  }

private:
  typedef std::array<std::size_t, 3> Triple;

  struct Hash
  {
    std::size_t operator()(const Triple& t) const
    {
      std::uint64_t h = 0;
      for (std::uint64_t x : t) h = (h ^ x) * 0x9e3779b97f4a7c15u, h ^= h >> 32;
      return std::size_t(h);
    }
  };

  std::size_t corners() const { return m_vertex.size(); }
  std::size_t place(std::size_t corner) const { return m_place[m_vertex[corner]]; }

  static std::size_t next(std::size_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

  // Triangles with the same three places are the two sides of a sheet, or drawn twice. Nothing is welded to them: they
  // would stick together.
  void find_layers()
  {
    std::unordered_map<Triple, std::size_t, Hash> first;
    first.reserve(corners() / 3);
    m_is_layer.assign(corners() / 3, 0);
    for (std::size_t t = 0; t < m_is_layer.size(); ++t) {
      Triple key = {{place(3 * t), place(3 * t + 1), place(3 * t + 2)}};
      std::sort(key.begin(), key.end());
      const auto inserted = first.emplace(key, t);
      if (!inserted.second) m_is_layer[t] = m_is_layer[inserted.first->second] = 1;
    }
  }

  void join_triangles()
  {
    m_rank.assign(corners(), 0);
    m_parent.resize(corners());
    auto fans = Animated_mesh_features::internal::disjoint_sets(m_rank.data(), m_parent.data());
    for (std::size_t c = 0; c < corners(); ++c) fans.make_set(c);
    m_result.welded_edges = m_result.open_edges = 0;
    const auto join = [&](std::size_t c, std::size_t d) {
      fans.union_set(c, next(d));
      fans.union_set(next(c), d);
    };
    const auto place_of = [this](std::size_t c) { return place(c); };
    for_each_edge(corners(), m_place.size(), place_of, [&](std::size_t* first, std::size_t* last) {
      // what the file itself joins stays joined
      for (std::size_t* c = first; c != last; ++c) {
        std::size_t others = 0, other = 0;
        for (std::size_t* d = first; d != last; ++d) {
          if (d == c || !is_same_edge_of_file(*c, *d)) continue;
          ++others;
          other = *d;
        }
        if (others == 0)
          m_borders.push_back(*c);
        else if (others == 1 && m_vertex[*c] == m_vertex[next(other)] && *c < other)
          join(*c, other);
      }
      const bool is_seam = m_borders.size() == 2 && place(m_borders[0]) == place(next(m_borders[1])) &&
                           may_be_welded(m_borders[0]) && may_be_welded(m_borders[1]);
      if (is_seam) {
        join(m_borders[0], m_borders[1]);
        ++m_result.welded_edges;
      } else if (m_borders.size() > 1) {
        ++m_result.open_edges;
      }
      m_borders.clear();
    });
    m_fan.resize(corners());
    for (std::size_t c = 0; c < corners(); ++c) m_fan[c] = fans.find_set(c);
  }

  bool is_same_edge_of_file(std::size_t c, std::size_t d) const
  {
    const std::size_t a = m_vertex[c], b = m_vertex[next(c)], e = m_vertex[d], f = m_vertex[next(d)];
    return (a == e && b == f) || (a == f && b == e);
  }

  bool may_be_welded(std::size_t c) const
  {
    return !m_is_layer[c / 3] && !m_is_apart[place(c)] && !m_is_apart[place(next(c))];
  }

  // A vertex for each fan of triangles, in the order of the first vertices of the file in them.
  void number_vertices()
  {
    const std::size_t none = (std::numeric_limits<std::size_t>::max)();
    std::vector<std::size_t> smallest(corners(), none); // by the corner that stands for the fan
    for (std::size_t c = 0; c < corners(); ++c) smallest[m_fan[c]] = (std::min)(smallest[m_fan[c]], m_vertex[c]);
    std::vector<std::size_t> ends(m_place.size() + 1, 0);
    for (std::size_t c = 0; c < corners(); ++c)
      if (m_fan[c] == c) ++ends[smallest[c] + 1];
    for (std::size_t v = 0; v < m_place.size(); ++v) ends[v + 1] += ends[v];
    m_vertices = ends.back();
    std::vector<std::size_t> number(corners(), none);
    for (std::size_t c = 0; c < corners(); ++c)
      if (m_fan[c] == c) number[c] = ends[smallest[c]]++; // starts become ends on the way
    m_result.triangles.assign(corners() / 3, Triple());
    for (std::size_t c = 0; c < corners(); ++c) m_result.triangles[c / 3][c % 3] = number[m_fan[c]];
  }

  // A fan that passes the same place twice could leave two edges with the same ends. Where that happens, nothing is
  // welded; rare, and local. Returns whether there was any such place that is not known yet.
  bool keep_conflicts_apart()
  {
    bool is_new = false;
    const auto vertex = [this](std::size_t c) { return m_result.triangles[c / 3][c % 3]; };
    for_each_edge(corners(), m_vertices, vertex, [&](std::size_t* first, std::size_t* last) {
      const bool is_fine = last - first == 1 || (last - first == 2 && vertex(first[0]) == vertex(next(first[1])));
      if (is_fine) return;
      for (std::size_t c : {*first, next(*first)}) {
        is_new = is_new || !m_is_apart[place(c)];
        m_is_apart[place(c)] = 1;
      }
    });
    return is_new;
  }

  void list_origins(std::size_t number_of_file_vertices)
  {
    std::vector<std::pair<std::size_t, std::size_t>> rows; // vertex and vertex of the file
    rows.reserve(corners());
    for (std::size_t c = 0; c < corners(); ++c) rows.emplace_back(m_result.triangles[c / 3][c % 3], m_vertex[c]);
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    std::vector<char> uses(number_of_file_vertices, 0);
    m_result.first.assign(1, 0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      m_result.file_vertices.push_back(rows[i].second);
      if (i + 1 == rows.size() || rows[i + 1].first != rows[i].first) m_result.first.push_back(i + 1);
      char& n = uses[rows[i].second];
      if (n == 1) ++m_result.split_vertices;
      if (n < 2) ++n;
    }
  }

  const std::vector<std::size_t>& m_place; // of each vertex of the file
  std::vector<char> m_is_apart;            // places where nothing is welded
  std::vector<std::size_t> m_vertex;       // of the file, for each corner
  std::vector<char> m_is_layer;            // for each triangle
  std::vector<std::size_t> m_rank, m_parent, m_fan, m_borders;
  std::size_t m_vertices = 0;
  Welded_surface m_result;
};

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesModels

sews up a surface that a format cut open: two borders become one edge if their ends are at the same two places and they
run in opposite directions, and if they are the only two there. Vertices are welded by this alone, never because they
merely touch, so that the result is a manifold wherever the file's own triangles are one; what cannot be sewn in this
way (a third border, another orientation, the two sides of a sheet) stays as the file has it.

A vertex of the file at which parts of the surface meet in a point only becomes several ones.

\param triangles corners are vertices of the file
\param place for each vertex of the file a number that is the same for all that are to be taken as coincident, and less
  than the number of vertices: `Coincident_vertices::first_of_class()`

Expected time linear in the number of triangles, but for sorting vertices' own edges.
*/
inline Welded_surface weld_surface(const std::vector<std::array<std::size_t, 3>>& triangles,
                                   const std::vector<std::size_t>& place)
{
  return internal::Surface_welder(triangles, place)();
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WELD_SURFACE_H
