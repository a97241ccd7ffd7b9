// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/thinned_triangles.h"

#include "running/Interruption.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace Programs {

namespace {

typedef std::uint32_t Index;
typedef std::vector<Eigen::Vector3f> Shape;

constexpr float length_weight = 0.02f; // against the distance from planes: on flat parts, the shortest edges go first
constexpr float least_cosine = 0.3f;   // between a triangle's normals before and after
constexpr double share_of_round = 0.5; // of the candidates of a round, the cheaper ones

struct Collapse
{
  float cost;
  Index from, to;

  bool operator<(const Collapse& other) const
  {
    return cost != other.cost ? cost < other.cost : from < other.from;
  }
};

// One round of collapses that do not meet.
class Round
{
public:
  Round(Triangles& triangles, const std::vector<Shape>& shapes)
    : m_triangles(triangles)
    , m_shapes(shapes)
    , m_starts(shapes.front().size() + 1, 0)
    , m_incident(3 * triangles.size())
  {
    for (const auto& t : triangles)
      for (Index v : t) ++m_starts[v + 1];
    for (std::size_t v = 0; v + 1 < m_starts.size(); ++v) m_starts[v + 1] += m_starts[v];
    std::vector<std::size_t> next(m_starts.begin(), m_starts.end() - 1);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (Index v : triangles[i]) m_incident[next[v]++] = Index(i);
  }

  std::size_t number_of_vertices() const
  {
    std::size_t n = 0;
    for (std::size_t v = 0; v + 1 < m_starts.size(); ++v) n += m_starts[v + 1] > m_starts[v] ? 1 : 0;
    return n;
  }

  // Takes at most so many vertices away; how many it were.
  std::size_t collapse(std::size_t most)
  {
    std::vector<Collapse> candidates;
    for (std::size_t v = 0; v + 1 < m_starts.size(); ++v) {
      if (v % 4096 == 0) Interruption::check();
      const Collapse c = cheapest(Index(v));
      if (c.cost < (std::numeric_limits<float>::max)()) candidates.push_back(c);
    }
    std::sort(candidates.begin(), candidates.end());
    const std::size_t considered = std::size_t(std::ceil(share_of_round * double(candidates.size())));
    std::vector<char> is_locked(m_starts.size(), 0), is_gone(m_triangles.size(), 0);
    std::size_t done = 0;
    for (std::size_t i = 0; i < considered && done < most; ++i) {
      const Collapse& c = candidates[i];
      find_ring(c.from);
      if (is_locked[c.from] || std::any_of(m_ring.begin(), m_ring.end(), [&](Index w) { return is_locked[w]; })) continue;
      is_locked[c.from] = 1;
      for (Index w : m_ring) is_locked[w] = 1;
      for (std::size_t k = m_starts[c.from]; k < m_starts[c.from + 1]; ++k) {
        auto& t = m_triangles[m_incident[k]];
        if (std::find(t.begin(), t.end(), c.to) != t.end())
          is_gone[m_incident[k]] = 1;
        else
          std::replace(t.begin(), t.end(), c.from, c.to);
      }
      ++done;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < m_triangles.size(); ++i)
      if (!is_gone[i]) m_triangles[kept++] = m_triangles[i];
    m_triangles.resize(kept);
    return done;
  }

private:
  // The neighbours of a vertex, each once; whether it has a full disc of triangles around it.
  bool find_ring(Index v)
  {
    m_ring.clear();
    for (std::size_t k = m_starts[v]; k < m_starts[v + 1]; ++k)
      for (Index w : m_triangles[m_incident[k]])
        if (w != v) m_ring.push_back(w);
    std::sort(m_ring.begin(), m_ring.end());
    const auto last = std::unique(m_ring.begin(), m_ring.end());
    const bool is_disc = 2 * std::size_t(last - m_ring.begin()) == m_ring.size() && m_starts[v + 1] - m_starts[v] >= 3;
    m_ring.erase(last, m_ring.end());
    return is_disc;
  }

  Collapse cheapest(Index v)
  {
    Collapse best{(std::numeric_limits<float>::max)(), v, v};
    if (!find_ring(v)) return best;
    // by the rest shape, then as it is in all of them
    std::array<Collapse, max_tries> tries{};
    std::size_t n = 0;
    for (Index w : m_ring) {
      const Collapse c{cost(m_shapes.front(), v, w), v, w};
      if (n < tries.size()) tries[n++] = c;
      else if (const auto worst = std::max_element(tries.begin(), tries.end()); c.cost < worst->cost) *worst = c;
    }
    const auto is_before = [](const Collapse& a, const Collapse& b) {
      return a.cost != b.cost ? a.cost < b.cost : a.to < b.to;
    };
    for (std::size_t i = 1; i < n; ++i) // so few that this is the fastest way to sort them
      for (std::size_t j = i; j > 0 && is_before(tries[j], tries[j - 1]); --j) std::swap(tries[j], tries[j - 1]);
    for (std::size_t i = 0; i < n; ++i) {
      Collapse c = tries[i];
      if (!(c.cost < best.cost) || !keeps_topology(v, c.to) || turns_over(v, c.to)) continue;
      for (const Shape& shape : m_shapes) c.cost = (std::max)(c.cost, cost(shape, v, c.to));
      if (c.cost < best.cost) best = c;
    }
    return best;
  }

  float cost(const Shape& shape, Index v, Index w) const
  {
    const Eigen::Vector3f move = shape[w] - shape[v];
    float farthest = 0;
    for (std::size_t k = m_starts[v]; k < m_starts[v + 1]; ++k) {
      const Eigen::Vector3f normal = normal_of(shape, m_triangles[m_incident[k]]);
      const float length = normal.norm();
      if (length > 0) farthest = (std::max)(farthest, std::abs(normal.dot(move)) / length);
    }
    return farthest + length_weight * move.norm();
  }

  template <class Corners>
  static Eigen::Vector3f normal_of(const Shape& shape, const Corners& t)
  {
    return (shape[t[1]] - shape[t[0]]).cross(shape[t[2]] - shape[t[0]]);
  }

  // Both ends have exactly the two vertices in common that lie opposite of their edge.
  bool keeps_topology(Index v, Index w)
  {
    m_common.clear();
    for (std::size_t k = m_starts[w]; k < m_starts[w + 1]; ++k)
      for (Index u : m_triangles[m_incident[k]])
        if (u != w && u != v && std::binary_search(m_ring.begin(), m_ring.end(), u)) m_common.push_back(u);
    std::sort(m_common.begin(), m_common.end());
    return std::unique(m_common.begin(), m_common.end()) - m_common.begin() == 2;
  }

  bool turns_over(Index v, Index w) const
  {
    const Shape& rest = m_shapes.front();
    for (std::size_t k = m_starts[v]; k < m_starts[v + 1]; ++k) {
      auto t = m_triangles[m_incident[k]];
      if (std::find(t.begin(), t.end(), w) != t.end()) continue;
      const Eigen::Vector3f before = normal_of(rest, t);
      std::replace(t.begin(), t.end(), v, w);
      const Eigen::Vector3f after = normal_of(rest, t);
      if (!(before.dot(after) > least_cosine * before.norm() * after.norm())) return true;
    }
    return false;
  }

  static constexpr std::size_t max_tries = 3;

  Triangles& m_triangles;
  const std::vector<Shape>& m_shapes;
  std::vector<std::size_t> m_starts;
  std::vector<Index> m_incident, m_ring, m_common;
};

} // namespace

Triangles thinned_triangles(Triangles triangles, const std::vector<Shape>& shapes, std::size_t most_vertices)
{
  for (;;) {
    Round round(triangles, shapes);
    const std::size_t n = round.number_of_vertices();
    if (n <= most_vertices || round.collapse(n - most_vertices) == 0) return triangles;
  }
}

} // namespace Programs
