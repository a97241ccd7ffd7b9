// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_VIEW_DEPTH_MAP_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_VIEW_DEPTH_MAP_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// What of a surface hides what, along a direction and, from the same projection, along its opposite: the greatest and the
// least height along the direction at each texel of a square around the unit sphere, in which the surface lies.
//
// A vertex is visible if nothing is above it. Since it lies on the surface itself, it is moved away from it by one and a
// half texels, half the diagonal of those between which is interpolated for slopes of up to 45 degrees; so what is thinner
// than that, 0.6 % of the body at 256 texels, hides nothing behind it. Against rays the map is some ten times as fast.
class View_depth_map
{
public:
  typedef Eigen::Vector3f Vector;
  typedef std::array<std::uint32_t, 3> Triangle;

  explicit View_depth_map(std::size_t size)
    : m_size(long(size))
    , m_scale(float(size) / 2 * 0.97f) // what is moved out of the unit sphere stays on the map
    , m_high(size * size)
    , m_low(size * size)
  {}

  // `outer_sides` are those of the triangles, see outer_sides(). What faces away on a closed surface is nowhere nearer than
  // what faces the viewer. The heights from below are drawn only if they are needed.
  void draw(const std::vector<Vector>& points, const std::vector<Triangle>& triangles,
            const std::vector<std::int8_t>& outer_sides, const Eigen::Vector3d& direction, bool from_below)
  {
    const Eigen::Vector3d u = direction.unitOrthogonal();
    m_axes.row(0) = u.transpose().cast<float>();
    m_axes.row(1) = direction.cross(u).transpose().cast<float>();
    m_axes.row(2) = direction.transpose().cast<float>();
    m_axes *= m_scale;
    std::fill(m_high.begin(), m_high.end(), -beyond);
    if (from_below) std::fill(m_low.begin(), m_low.end(), beyond);
    m_projected.resize(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) m_projected[v] = place(points[v]);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const Triangle& t = triangles[i];
      draw(m_projected[t[0]], m_projected[t[1]], m_projected[t[2]], outer_sides[i], from_below);
    }
  }

  // From 0 to 1: how much of the four texels around a point is free of what is above it, or below it if not `from_above`.
  // `normal`, of length 1 or 0, points to the side that is looked from.
  float visibility(const Vector& point, const Vector& normal, bool from_above) const
  {
    Vector p = place(point + 1.5f / m_scale * normal);
    p[0] -= 0.5f, p[1] -= 0.5f;
    if (!(p[0] >= 0 && p[1] >= 0 && p[0] < float(m_size - 1) && p[1] < float(m_size - 1))) return 1;
    const long x = long(p[0]), y = long(p[1]);
    const float s = p[0] - float(x), t = p[1] - float(y), height = p[2];
    const std::size_t i = std::size_t(y * m_size + x), n = std::size_t(m_size);
    const auto is_free = [&](std::size_t j) {
      return (from_above ? height >= m_high[j] : height <= m_low[j]) ? 1.f : 0.f;
    };
    return (1 - t) * ((1 - s) * is_free(i) + s * is_free(i + 1)) +
           t * ((1 - s) * is_free(i + n) + s * is_free(i + n + 1));
  }

private:
  // in texels, the third along the direction
  Vector place(const Vector& p) const
  {
    const float middle = float(m_size) / 2;
    return m_axes * p + Vector(middle, middle, 0);
  }

  // Most triangles are smaller than a texel and cover no centre of one: they are done with first.
  void draw(const Vector& a, const Vector& b, const Vector& c, int outer_side, bool from_below)
  {
    const auto least = [](float x, float y, float z) { return (std::min)((std::min)(x, y), z); };
    const auto most = [](float x, float y, float z) { return (std::max)((std::max)(x, y), z); };
    const auto first = [](float x) { return int(x + 0.5f); }; // the texel whose centre comes next; x is not negative
    const int left = first(least(a[0], b[0], c[0])), right = first(most(a[0], b[0], c[0]));
    const int top = first(least(a[1], b[1], c[1])), bottom = first(most(a[1], b[1], c[1]));
    if (left >= right || top >= bottom) return;
    const float bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
    const float area = bx * cy - by * cx;
    if (!(std::abs(area) > 1e-12f)) return;
    const bool is_seen_above = area * float(outer_side) >= 0, is_seen_below = from_below && area * float(outer_side) <= 0;
    const Box box = {left, right, top, bottom};
    if (is_seen_above && is_seen_below)
      fill<true, true>(box, a, b, c, area);
    else if (is_seen_above)
      fill<true, false>(box, a, b, c, area);
    else if (is_seen_below)
      fill<false, true>(box, a, b, c, area);
  }

  // Texels, to before the right and the bottom.
  struct Box
  {
    int left, right, top, bottom;
  };

  template <bool above, bool below>
  void fill(const Box& box, const Vector& a, const Vector& b, const Vector& c, float area)
  {
    const float bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
    const float inverse = 1 / area, slack = -1e-4f; // no gaps between neighbours, whose edges round differently
    const float s_x = cy * inverse, s_y = -cx * inverse, t_x = -by * inverse, t_y = bx * inverse;
    const float bz = b[2] - a[2], cz = c[2] - a[2];
    for (int y = box.top; y < box.bottom; ++y) {
      const float dy = float(y) + 0.5f - a[1];
      for (int x = box.left; x < box.right; ++x) {
        const float dx = float(x) + 0.5f - a[0];
        const float s = s_x * dx + s_y * dy, t = t_x * dx + t_y * dy;
        // Which of so few texels are inside no processor can guess: heights that never count are faster than a branch.
        const float outside = (std::min)((std::min)(s, t), 1 - s - t) < slack ? beyond : 0.f;
        const float height = a[2] + s * bz + t * cz;
        const std::size_t i = std::size_t(y) * std::size_t(m_size) + std::size_t(x);
        if (above) m_high[i] = (std::max)(m_high[i], height - outside);
        if (below) m_low[i] = (std::min)(m_low[i], height + outside);
      }
    }
  }

  static constexpr float beyond = 1e30f; // beyond all heights

  long m_size;
  float m_scale; // texels in a radius of the body
  Eigen::Matrix3f m_axes = Eigen::Matrix3f::Zero();
  std::vector<float> m_high, m_low;
  std::vector<Vector> m_projected;
};

} // namespace internal

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_VIEW_DEPTH_MAP_H
