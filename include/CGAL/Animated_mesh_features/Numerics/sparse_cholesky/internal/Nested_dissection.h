// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_NESTED_DISSECTION_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_NESTED_DISSECTION_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/minimum_degree_order.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// An order of elimination with little fill for a symmetric matrix whose graph is a mesh; A. George, Nested dissection
// of a regular finite element mesh, SIAM J. Numer. Anal. 10(2), 1973. A part is cut in two by those vertices on one
// side of a plane that have neighbours on the other. They come last, and before them the two sides, cut in the same
// way; small parts are ordered by minimum degree. A factor of a surface has O(N log N) entries and takes O(N^1.5)
// operations.
//
// Positions count in integers, so that the order is the same on all machines. How good the order is depends on them,
// but not that it is one: vertices may lie at the same place.
class Nested_dissection
{
public:
  typedef Compressed_rows::Index Index;

  // Parts up to this size are ordered by minimum degree, which is as good for them as cutting them, and sooner done
  // (measured; for a million vertices in rows and columns, minimum degree alone needs 1.7 times the entries and 4 times
  // the operations).
  static constexpr std::size_t largest_part = 16000;

  // `points`: of the vertices, anything with three coordinates.
  template <class Point>
  Nested_dissection(const Compressed_rows& neighbours, const std::vector<Point>& points,
                    std::size_t largest = largest_part)
    : m_neighbours(neighbours)
    , m_largest(largest)
    , m_places(places_of(points))
    , m_order(points.size())
    , m_position(points.size())
  {
    std::iota(m_order.begin(), m_order.end(), Index(0));
    std::iota(m_position.begin(), m_position.end(), Index(0));
    dissect(0, m_order.size());
  }

  // The vertex that is eliminated first, and so on.
  const std::vector<Index>& order() const { return m_order; }

private:
  typedef std::array<std::int32_t, 3> Place;

  // Places of planes that are tried along an axis.
  static constexpr std::int32_t bins = 256;

  // Of each side of a cut, in what it separates.
  static constexpr double smallest_share = 0.3;

  struct Cut
  {
    std::size_t axis = 0;
    std::int32_t height = 0; // the lower side: up to it
    bool is_below = false;   // on which side the separator is
    double cost = (std::numeric_limits<double>::max)();
    bool exists() const { return cost < (std::numeric_limits<double>::max)(); }
  };

  template <class Point>
  static std::vector<Place> places_of(const std::vector<Point>& points)
  {
    double low[3] = {}, extent = 0;
    for (int i = 0; i < 3 && !points.empty(); ++i) {
      const auto less = [i](const Point& p, const Point& q) { return p[i] < q[i]; };
      const auto ends = std::minmax_element(points.begin(), points.end(), less);
      low[i] = (*ends.first)[i] / 2; // halves, whose differences are finite
      extent = (std::max)(extent, (*ends.second)[i] / 2 - low[i]);
    }
    if (!(extent > 0)) extent = 1;
    std::vector<Place> places(points.size());
    for (std::size_t v = 0; v < points.size(); ++v)
      for (int i = 0; i < 3; ++i) places[v][i] = std::int32_t((points[v][i] / 2 - low[i]) / extent * (1 << 24));
    return places;
  }

  // Whether v is in the part [first, last) of the order.
  bool is_in(Index v, std::size_t first, std::size_t last) const
  {
    return m_position[v] >= first && m_position[v] < last;
  }

  void dissect(std::size_t first, std::size_t last)
  {
    cancellation_point();
    const Cut cut = last - first > m_largest ? best_cut(first, last) : Cut();
    if (!cut.exists()) {
      order_by_degree(first, last);
      return;
    }
    const auto is_lower = [&](Index v) { return m_places[v][cut.axis] <= cut.height; };
    std::vector<Index> lower, upper, separator;
    for (std::size_t i = first; i < last; ++i) {
      const Index v = m_order[i];
      const bool lies_lower = is_lower(v);
      const auto is_across = [&](Index w) { return is_in(w, first, last) && is_lower(w) != lies_lower; };
      const Compressed_rows::Row row = m_neighbours[v];
      if (lies_lower == cut.is_below && std::any_of(row.begin(), row.end(), is_across))
        separator.push_back(v);
      else
        (lies_lower ? lower : upper).push_back(v);
    }
    const std::size_t middle = first + lower.size(), end = middle + upper.size();
    place(lower, first);
    place(upper, middle);
    place(separator, end);
    dissect(first, middle);
    dissect(middle, end);
  }

  void place(const std::vector<Index>& part, std::size_t first)
  {
    for (std::size_t i = 0; i < part.size(); ++i) {
      m_order[first + i] = part[i];
      m_position[part[i]] = Index(first + i);
    }
  }

  // The cut with the smallest separator for the sizes of its sides, none if all lie at one place.
  Cut best_cut(std::size_t first, std::size_t last) const
  {
    Place low = m_places[m_order[first]], high = low;
    for (std::size_t i = first; i < last; ++i) extend(low, high, m_places[m_order[i]]);
    // In a bin, how many more than in the one before: vertices below the upper end of the bin, separators on either
    // side of that.
    struct Counts
    {
      std::int32_t vertices = 0, below = 0, above = 0;
    };
    std::vector<std::array<Counts, 3>> counts(bins);
    std::array<std::int32_t, 3> width;
    for (int i = 0; i < 3; ++i) width[i] = (high[i] - low[i]) / bins + 1;
    for (std::size_t i = first; i < last; ++i) {
      const Index v = m_order[i];
      Place lowest = m_places[v], highest = lowest;
      for (Index w : m_neighbours[v])
        if (is_in(w, first, last)) extend(lowest, highest, m_places[w]);
      for (int k = 0; k < 3; ++k) {
        const auto bin = [&](const Place& p) { return std::size_t((p[k] - low[k]) / width[k]); };
        const std::size_t own = bin(m_places[v]), from = bin(lowest), to = bin(highest);
        ++counts[own][k].vertices;
        ++counts[own][k].below; // of the planes at the upper ends of the bins [own, to)
        --counts[to][k].below;
        ++counts[from][k].above; // of those of [from, own)
        --counts[own][k].above;
      }
    }
    Cut best;
    const double n = double(last - first);
    for (std::size_t k = 0; k < 3; ++k) {
      double lower = 0, below = 0, above = 0;
      for (std::int32_t bin = 0; bin < bins; ++bin) {
        const Counts& c = counts[std::size_t(bin)][k];
        lower += c.vertices;
        below += c.below;
        above += c.above;
        const std::int32_t height = low[k] + (bin + 1) * width[k] - 1;
        improve(best, {k, height, true}, below, lower - below, n - lower);
        improve(best, {k, height, false}, above, lower, n - lower - above);
      }
    }
    return best;
  }

  static void extend(Place& low, Place& high, const Place& p)
  {
    for (int i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  }

  static void improve(Cut& best, Cut cut, double separator, double lower, double upper)
  {
    if ((std::min)(lower, upper) < smallest_share * (lower + upper)) return;
    cut.cost = separator / (lower * upper);
    if (cut.cost < best.cost) best = cut;
  }

  // Pairs of vertices around a part, for each vertex of it, at most; where meshes are cut there are some 20.
  static constexpr std::size_t most_pairs = 100;

  // Neighbours that are eliminated later take part, as the clique that they end up as once all of the part are gone,
  // which saves some fill. Where there are so many that a clique would take much memory, minimum degree leaves them out
  // as too dense anyway.
  void order_by_degree(std::size_t first, std::size_t last)
  {
    const std::vector<Index> part(m_order.begin() + std::ptrdiff_t(first), m_order.begin() + std::ptrdiff_t(last));
    std::vector<Index> later;
    for (Index v : part)
      for (Index w : m_neighbours[v])
        if (m_position[w] >= last) later.push_back(w);
    std::sort(later.begin(), later.end());
    later.erase(std::unique(later.begin(), later.end()), later.end());
    if (later.size() * later.size() / 2 > most_pairs * part.size()) later.clear();
    std::vector<std::vector<Index>> rows(part.size() + later.size());
    const auto join = [&](std::size_t v, std::size_t w) {
      rows[v].push_back(Index(w));
      rows[w].push_back(Index(v));
    };
    for (std::size_t i = 0; i < part.size(); ++i)
      for (Index w : m_neighbours[part[i]])
        if (is_in(w, first, last))
          rows[i].push_back(Index(m_position[w] - first));
        else if (m_position[w] >= last && !later.empty())
          join(i, part.size() + std::size_t(std::lower_bound(later.begin(), later.end(), w) - later.begin()));
    for (std::size_t i = 0; i < later.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) join(part.size() + i, part.size() + j);
    std::vector<Index> order = minimum_degree_order(Compressed_rows(std::move(rows)));
    order.erase(std::remove_if(order.begin(), order.end(), [&](Index i) { return i >= part.size(); }), order.end());
    for (Index& i : order) i = part[i];
    place(order, first);
  }

  const Compressed_rows& m_neighbours;
  std::size_t m_largest;
  std::vector<Place> m_places;
  std::vector<Index> m_order, m_position; // a part is a stretch of the order
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_INTERNAL_NESTED_DISSECTION_H
