// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_POINT_SET_INDEX_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_POINT_SET_INDEX_H

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Tells whether there is a point at a place, to within some 1e-5 of the extent of the points: a file may have six digits.
// Expected constant time.
class Point_set_index
{
public:
  typedef std::array<double, 3> Position;

  explicit Point_set_index(const std::vector<Position>& points)
  {
    double extent = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto ends = std::minmax_element(points.begin(), points.end(),
                                            [k](const Position& a, const Position& b) { return a[k] < b[k]; });
      m_origin[k] = (*ends.first)[k];
      extent = (std::max)(extent, (*ends.second)[k] - m_origin[k]);
    }
    m_tolerance = 1e-5 * extent;
    for (const Position& p : points) m_cells.insert(cell(p, {{0, 0, 0}}));
  }

  double tolerance() const { return m_tolerance; }

  // Looks into the cells of twice the tolerance that a cube of that size around the place meets.
  bool has(const Position& p) const
  {
    for (double x : {-0.5, 0.5})
      for (double y : {-0.5, 0.5})
        for (double z : {-0.5, 0.5})
          if (m_cells.count(cell(p, {{x, y, z}})) != 0) return true;
    return false;
  }

private:
  typedef std::array<double, 3> Cell; // whole numbers

  Cell cell(const Position& p, const Position& offset) const
  {
    const double size = m_tolerance > 0 ? 2 * m_tolerance : 1;
    Cell c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = std::floor((p[k] - m_origin[k]) / size + offset[k]) + 0.;
    return c;
  }

  Position m_origin = {{0, 0, 0}};
  double m_tolerance = 0;
  std::unordered_set<Cell, boost::hash<Cell>> m_cells;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_POINT_SET_INDEX_H
