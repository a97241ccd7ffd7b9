// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TURN_FILTER_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TURN_FILTER_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_positions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Tells which triangles a collapse would turn over, in any column. It remembers, for each vertex that is left, the
// normals of the original around all that it has taken the place of, as long as twice their areas.
class Turn_filter
{
public:
  typedef std::array<std::vector<float>, 3> Rows; // a vector in each column

  Turn_filter(const Pose_positions& original, double least_cosine)
    : m_normals(original.number_of_vertices(), original.number_of_columns())
    , m_least_cosine(least_cosine)
  {}

  // of the original around a vertex
  void set_normals(const Rest_shape& rest, const Pose_positions& original, std::size_t v)
  {
    typedef Rest_shape::Point Point;
    for (std::size_t f = 0; f < m_normals.number_of_columns(); ++f) {
      Point sum(0, 0, 0);
      for (Rest_shape::Index t : rest.incident_triangles()[v]) {
        const Rest_shape::Triangle& triangle = rest.triangles()[t];
        Point p[3];
        for (std::size_t k = 0; k < 3; ++k) {
          const std::array<double, 3> x = original.point(triangle[k], f);
          p[k] = Point(x[0], x[1], x[2]);
        }
        sum += (p[1] - p[0]).cross(p[2] - p[0]);
      }
      for (int axis = 0; axis < 3; ++axis) m_normals.row(v, axis)[f] = float(sum[axis]);
    }
  }

  // around what a vertex in place of both would stand for
  void add_normals(std::size_t i, std::size_t j, Rows& sum) const
  {
    for (int axis = 0; axis < 3; ++axis) {
      const float *const n = m_normals.row(i, axis), *const m = m_normals.row(j, axis);
      std::vector<float>& row = sum[std::size_t(axis)];
      row.resize(m_normals.number_of_columns());
      for (std::size_t f = 0; f < row.size(); ++f) row[f] = n[f] + m[f];
    }
  }

  void commit(std::size_t kept, const Rows& normals)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::copy(normals[axis].begin(), normals[axis].end(), m_normals.row(kept, int(axis)));
  }

  // Whether the triangle turns over, or shrinks to nothing, in any column, when its first vertex moves to `place` and
  // stands for what has the normals `normals`: by its own normal, and by that of the original around its corners, so
  // that it does not turn little by little. Where it is degenerate already, there is nothing to turn over.
  bool turns(const Pose_positions& current, std::size_t moved, std::size_t b, std::size_t d, const Rows& place,
             const Rows& normals) const
  {
    const float *const ax = current.row(moved, 0), *const ay = current.row(moved, 1), *const az = current.row(moved, 2);
    const float *const bx = current.row(b, 0), *const by = current.row(b, 1), *const bz = current.row(b, 2);
    const float *const dx = current.row(d, 0), *const dy = current.row(d, 1), *const dz = current.row(d, 2);
    const float *const nx = place[0].data(), *const ny = place[1].data(), *const nz = place[2].data();
    const float *const px = normals[0].data(), *const py = normals[1].data(), *const pz = normals[2].data();
    const float *const qx = m_normals.row(b, 0), *const qy = m_normals.row(b, 1), *const qz = m_normals.row(b, 2);
    const float *const rx = m_normals.row(d, 0), *const ry = m_normals.row(d, 1), *const rz = m_normals.row(d, 2);
    const float least = float(m_least_cosine);
    const std::size_t columns = current.number_of_columns();
    int bad = 0;
    for (std::size_t f = 0; f < columns; ++f) {
      const float ex = dx[f] - bx[f], ey = dy[f] - by[f], ez = dz[f] - bz[f];
      const float ux = ax[f] - bx[f], uy = ay[f] - by[f], uz = az[f] - bz[f];
      const float vx = nx[f] - bx[f], vy = ny[f] - by[f], vz = nz[f] - bz[f];
      const float ox = ey * uz - ez * uy, oy = ez * ux - ex * uz, oz = ex * uy - ey * ux;
      const float wx = ey * vz - ez * vy, wy = ez * vx - ex * vz, wz = ex * vy - ey * vx;
      const float dot = ox * wx + oy * wy + oz * wz;
      const float old_area = ox * ox + oy * oy + oz * oz, area = wx * wx + wy * wy + wz * wz;
      const float side = ex * ex + ey * ey + ez * ez;
      const float sx = px[f] + qx[f] + rx[f], sy = py[f] + qy[f] + ry[f], sz = pz[f] + qz[f] + rz[f];
      const int against = int(sx * wx + sy * wy + sz * wz < 0) & int(sx * ox + sy * oy + sz * oz >= 0);
      const int was_flat = int(old_area <= 1e-12f * side * side);
      const int turns = int(dot <= 0) | int(dot < least * (std::sqrt(old_area) * std::sqrt(area))) |
                        int(area <= 1e-10f * side * side) | against;
      bad |= turns & (1 - was_flat);
    }
    return bad != 0;
  }

private:
  Pose_positions m_normals;
  double m_least_cosine;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TURN_FILTER_H
