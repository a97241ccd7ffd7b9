// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TURN_FILTER_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TURN_FILTER_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_positions.h>
#include <CGAL/Animated_mesh_features/Applications/internal/turned_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Tells which triangles a collapse would turn over, in any column. It remembers, for each vertex that is left, which way
// the original around all that it has taken the place of looks: the sum of the normals of its triangles, as long as twice
// their areas, and the sum of these lengths.
class Turn_filter
{
public:
  typedef std::array<std::vector<float>, 3> Rows; // a vector in each column

  // which way the original looks
  struct Side
  {
    Rows normals;
    std::vector<float> areas;
  };

  Turn_filter(const Pose_positions& original, double least_cosine)
    : m_normals(original.number_of_vertices(), original.number_of_columns())
    , m_areas(original.number_of_vertices() * original.number_of_columns())
    , m_least_cosine(least_cosine)
  {}

  // of the original around a vertex
  void set_side(const Rest_shape& rest, const Pose_positions& original, std::size_t v)
  {
    typedef Rest_shape::Point Point;
    for (std::size_t f = 0; f < m_normals.number_of_columns(); ++f) {
      Point sum(0, 0, 0);
      double area = 0;
      for (Rest_shape::Index t : rest.incident_triangles()[v]) {
        const Rest_shape::Triangle& triangle = rest.triangles()[t];
        Point p[3];
        for (std::size_t k = 0; k < 3; ++k) {
          const std::array<double, 3> x = original.point(triangle[k], f);
          p[k] = Point(x[0], x[1], x[2]);
        }
        const Point n = (p[1] - p[0]).cross(p[2] - p[0]);
        sum += n;
        area += n.norm();
      }
      areas(v)[f] = float(area);
      for (int axis = 0; axis < 3; ++axis) m_normals.row(v, axis)[f] = float(sum[axis]);
    }
  }

  // of what a vertex in place of both would stand for
  void add_sides(std::size_t i, std::size_t j, Side& sum) const
  {
    const std::size_t columns = m_normals.number_of_columns();
    for (std::size_t axis = 0; axis < 3; ++axis)
      add_rows(m_normals.row(i, int(axis)), m_normals.row(j, int(axis)), columns, sum.normals[axis]);
    add_rows(areas(i), areas(j), columns, sum.areas);
  }

  // of what a vertex stands for
  void side(std::size_t v, Side& side) const
  {
    const std::size_t columns = m_normals.number_of_columns();
    for (std::size_t axis = 0; axis < 3; ++axis)
      side.normals[axis].assign(m_normals.row(v, int(axis)), m_normals.row(v, int(axis)) + columns);
    side.areas.assign(areas(v), areas(v) + columns);
  }

  void commit(std::size_t kept, const Side& side)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::copy(side.normals[axis].begin(), side.normals[axis].end(), m_normals.row(kept, int(axis)));
    std::copy(side.areas.begin(), side.areas.end(), areas(kept));
  }

  // Whether a triangle turns over, or shrinks to nothing, in any column, when its first vertex moves to `place` and
  // stands for what has the side `side`. Where the original around its corners has a side:
  // - it looks there, unless it looked away before;
  // - its normal turns by no more than it may, unless it looks to that side better than before, or well;
  // - it is no line, unless it was one before.
  bool turns(const Pose_positions& current, std::size_t moved, std::size_t b, std::size_t d, const Rows& place,
             const Side& side) const
  {
    const float *const ax = current.row(moved, 0), *const ay = current.row(moved, 1), *const az = current.row(moved, 2);
    const float *const bx = current.row(b, 0), *const by = current.row(b, 1), *const bz = current.row(b, 2);
    const float *const dx = current.row(d, 0), *const dy = current.row(d, 1), *const dz = current.row(d, 2);
    const float *const nx = place[0].data(), *const ny = place[1].data(), *const nz = place[2].data();
    const float *const px = side.normals[0].data(), *const py = side.normals[1].data(),
                       *const pz = side.normals[2].data();
    const float *const qx = m_normals.row(b, 0), *const qy = m_normals.row(b, 1), *const qz = m_normals.row(b, 2);
    const float *const rx = m_normals.row(d, 0), *const ry = m_normals.row(d, 1), *const rz = m_normals.row(d, 2);
    const float *const hx = m_normals.row(moved, 0), *const hy = m_normals.row(moved, 1),
                       *const hz = m_normals.row(moved, 2);
    const float *const pa = side.areas.data(), *const qa = areas(b), *const ra = areas(d), *const ha = areas(moved);
    const float least = float(m_least_cosine), has_side = float(least_side);
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
      const float old_length = std::sqrt(old_area), length = std::sqrt(area), edge = ex * ex + ey * ey + ez * ez;
      // the side around the corners, and before
      const float tx = qx[f] + rx[f], ty = qy[f] + ry[f], tz = qz[f] + rz[f];
      const float sx = px[f] + tx, sy = py[f] + ty, sz = pz[f] + tz;
      const float mx = hx[f] + tx, my = hy[f] + ty, mz = hz[f] + tz;
      const float s = std::sqrt(sx * sx + sy * sy + sz * sz), m = std::sqrt(mx * mx + my * my + mz * mz);
      const float look = sx * wx + sy * wy + sz * wz, old_look = mx * ox + my * oy + mz * oz;
      const int was_line = int(old_area <= 1e-12f * edge * edge), is_line = int(area <= 1e-10f * edge * edge);
      const int had_side = int(m >= has_side * (ha[f] + qa[f] + ra[f]));
      const int has_looked = int(old_look >= least_look * (m * old_length)) | was_line | (1 - had_side);
      const int looks = int(look >= least_look * (s * length));
      const int looks_well =
          int(look >= good_look * (s * length)) | int(look * (m * old_length) >= old_look * (s * length));
      const int has_turned = int(dot <= 0) | int(dot < least * (old_length * length));
      const int is_worse = ((has_turned & (1 - looks_well)) | is_line) & (1 - was_line);
      bad |= int(s >= has_side * (pa[f] + qa[f] + ra[f])) & (is_worse | ((1 - looks) & has_looked));
    }
    return bad != 0;
  }

private:
  // cosines: looks to a side, by more than roundings; looks well
  static constexpr float least_look = .01f, good_look = .5f;

  static void add_rows(const float* a, const float* b, std::size_t columns, std::vector<float>& sum)
  {
    sum.resize(columns);
    for (std::size_t f = 0; f < columns; ++f) sum[f] = a[f] + b[f];
  }

  float* areas(std::size_t v) { return m_areas.data() + v * m_normals.number_of_columns(); }
  const float* areas(std::size_t v) const { return m_areas.data() + v * m_normals.number_of_columns(); }

  Pose_positions m_normals;
  std::vector<float> m_areas;
  double m_least_cosine;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_TURN_FILTER_H
