// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_INTERNAL_POINT_GRID_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_INTERNAL_POINT_GRID_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// Points in cubes of the size of the distance within which they are looked for.
class Point_grid
{
public:
  typedef Rest_shape::Index Index;
  typedef Rest_shape::Point Point;

  // Some of `points`, which are kept by reference, by their indices; `distance` is positive.
  Point_grid(const std::vector<Point>& points, const std::vector<Index>& which, double distance)
    : m_points(&points)
    , m_distance(distance)
  {
    for (Index i : which) m_cells.emplace_back(cell(points[i]), i);
    std::sort(m_cells.begin(), m_cells.end());
  }

  // calls visit(index, distance) for each point within the distance.
  template <class Visit>
  void for_each_near(const Point& p, const Visit& visit) const
  {
    const Cell centre = cell(p);
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y) {
        // cubes in a column follow one another
        const Cell first = {{centre[0] + x, centre[1] + y, centre[2] - 1}};
        const Cell last = {{first[0], first[1], centre[2] + 1}};
        for (auto i = std::lower_bound(m_cells.begin(), m_cells.end(), std::make_pair(first, Index(0)));
             i != m_cells.end() && i->first <= last; ++i) {
          const double d = (p - (*m_points)[i->second]).norm();
          if (d <= m_distance) visit(i->second, d);
        }
      }
  }

private:
  typedef std::array<std::int64_t, 3> Cell;

  Cell cell(const Point& p) const
  {
    // far enough from the ends of the range, for a distance that is much too small, too
    const auto rank = [&](double x) {
      return std::int64_t(std::floor((std::max)(-1e15, (std::min)(1e15, x / m_distance))));
    };
    return {{rank(p[0]), rank(p[1]), rank(p[2])}};
  }

  const std::vector<Point>* m_points;
  double m_distance;
  std::vector<std::pair<Cell, Index>> m_cells; // sorted
};

} // namespace internal

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_INTERNAL_POINT_GRID_H
