// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSE_POSITIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSE_POSITIONS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Where vertices are in each column: the poses first, then the other frames, then the rest shape. The coordinates of
// a vertex are contiguous over the columns. Each column is relative to its own mean, so that a body that walks away
// loses no digits, and to a unit, which is to be the size of the body, so that no product leaves the range of numbers;
// single precision, which is that of caches, is then a ten-millionth of the body.
class Pose_positions
{
public:
  Pose_positions() = default;

  template <class FT>
  Pose_positions(const Rest_shape& rest, const Vertex_trajectories<FT>& trajectories,
                 const std::vector<std::size_t>& columns, double unit)
    : m_columns(columns.size() + 1)
    , m_values(3 * m_columns * rest.number_of_vertices())
  {
    const std::size_t n = rest.number_of_vertices();
    std::vector<double> sums(3 * m_columns, 0);
    const auto value = [&](std::size_t v, int axis, std::size_t c) {
      if (c + 1 == m_columns) return rest.points()[v][axis];
      return double(coordinate(trajectories, axis)(v, columns[c]));
    };
    for (std::size_t v = 0; v < n; ++v)
      for (int axis = 0; axis < 3; ++axis)
        for (std::size_t c = 0; c < m_columns; ++c) sums[axis * m_columns + c] += value(v, axis, c);
    for (double& s : sums) s /= double(n);
    for (std::size_t v = 0; v < n; ++v)
      for (int axis = 0; axis < 3; ++axis)
        for (std::size_t c = 0; c < m_columns; ++c)
          row(v, axis)[c] = float((value(v, axis, c) - sums[axis * m_columns + c]) / unit);
  }

  // a vector, of any meaning, for each vertex and column
  Pose_positions(std::size_t vertices, std::size_t columns)
    : m_columns(columns)
    , m_values(3 * columns * vertices)
  {}

  std::size_t number_of_vertices() const { return m_columns > 0 ? m_values.size() / (3 * m_columns) : 0; }
  std::size_t number_of_columns() const { return m_columns; }
  float* row(std::size_t v, int axis) { return m_values.data() + (3 * v + std::size_t(axis)) * m_columns; }
  const float* row(std::size_t v, int axis) const { return m_values.data() + (3 * v + std::size_t(axis)) * m_columns; }

  std::array<double, 3> point(std::size_t v, std::size_t column) const
  {
    return {{double(row(v, 0)[column]), double(row(v, 1)[column]), double(row(v, 2)[column])}};
  }

private:
  template <class FT>
  static const Spatio_temporal_field<FT>& coordinate(const Vertex_trajectories<FT>& t, int axis)
  {
    return axis == 0 ? t.x : axis == 1 ? t.y : t.z;
  }

  std::size_t m_columns = 0;
  std::vector<float> m_values;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSE_POSITIONS_H
