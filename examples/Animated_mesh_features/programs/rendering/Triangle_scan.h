// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_TRIANGLE_SCAN_H
#define PROGRAMS_RENDERING_TRIANGLE_SCAN_H

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace Programs::Rendering {

// A triangle in the plane of an image, and a quantity that is linear on it. Where are its samples? A header, since
// everything else that is drawn waits for this loop: the compiler puts what is done with a sample into it.
class Triangle_scan
{
public:
  // nothing
  Triangle_scan() = default;

  // corners (x, y, value)
  Triangle_scan(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
  {
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    m_is_empty = !(std::abs(area) > 0);
    if (m_is_empty) return;
    set_edge(0, b, c, area);
    set_edge(1, c, a, area);
    set_edge(2, a, b, area);
    for (int i = 0; i < 3; ++i) m_value[i] = a[2] * m_edge[0][i] + b[2] * m_edge[1][i] + c[2] * m_edge[2][i];
    m_low = a.cwiseMin(b).cwiseMin(c);
    m_high = a.cwiseMax(b).cwiseMax(c);
  }

  bool is_empty() const { return m_is_empty; }

  // the barycentric coordinates of a place, linear on the image
  Eigen::Array3d coordinates(double x, double y) const
  {
    return Eigen::Array3d(at(m_edge[0], x, y), at(m_edge[1], x, y), at(m_edge[2], x, y));
  }

  double value(double x, double y) const { return at(m_value, x, y); }

  // use(x, y, value) for each sample inside or on the border. Samples are at (x + 1/2, y + 1/2) in units of `step`, for
  // first_x <= x < last_x and first_y <= y < last_y.
  template <class Use>
  void operator()(double step, long first_x, long last_x, long first_y, long last_y, const Use& use) const
  {
    if (m_is_empty) return;
    const auto first = [&](double low, long least) { return (std::max)(double(least), std::ceil(low / step - 0.5)); };
    const auto last = [&](double high, long most) {
      return (std::min)(double(most), std::floor(high / step - 0.5) + 1);
    };
    // still as floating-point numbers, because a corner may be anywhere
    const double from_x = first(m_low[0], first_x), to_x = last(m_high[0], last_x);
    const double from_y = first(m_low[1], first_y), to_y = last(m_high[1], last_y);
    if (!(from_x < to_x && from_y < to_y)) return;
    for (long y = long(from_y); y < long(to_y); ++y) {
      const double sy = (double(y) + 0.5) * step;
      const auto is_inside = [&](long x) {
        const double sx = (double(x) + 0.5) * step;
        return at(m_edge[0], sx, sy) >= 0 && at(m_edge[1], sx, sy) >= 0 && at(m_edge[2], sx, sy) >= 0;
      };
      // Each edge is monotone along a row, also rounded: what is inside is an interval, whose ends are asked for exactly,
      // from one sample beyond where they should be.
      double low = from_x, high = to_x - 1;
      for (const Linear& e : m_edge) {
        if (e[0] == 0) continue;
        const double crossing = -(e[1] * sy + e[2]) / e[0] / step - 0.5;
        if (e[0] > 0)
          low = (std::max)(low, std::floor(crossing));
        else
          high = (std::min)(high, std::ceil(crossing));
      }
      if (!(low <= high)) continue;
      long first_inside = long(low), last_inside = long(high);
      while (first_inside <= last_inside && !is_inside(first_inside)) ++first_inside;
      while (last_inside > first_inside && !is_inside(last_inside)) --last_inside;
      for (long x = first_inside; x <= last_inside; ++x) use(x, y, at(m_value, (double(x) + 0.5) * step, sy));
    }
  }

private:
  typedef std::array<double, 3> Linear; // x, y, 1

  static double at(const Linear& f, double x, double y) { return f[0] * x + f[1] * y + f[2]; }

  // 0 on the line through p and q, 1 at the third corner
  void set_edge(int i, const Eigen::Vector3d& p, const Eigen::Vector3d& q, double area)
  {
    // The same bits for both triangles of an edge but for the sign, or there would be gaps: from the lesser end.
    const bool swapped = q[0] < p[0] || (q[0] == p[0] && q[1] < p[1]);
    const Eigen::Vector3d &u = swapped ? q : p, &v = swapped ? p : q;
    const double sign = (swapped ? -1 : 1) / area;
    const double a = u[1] - v[1], b = v[0] - u[0];
    m_edge[std::size_t(i)] = {{sign * a, sign * b, -sign * (a * u[0] + b * u[1])}};
  }

  bool m_is_empty = true;
  std::array<Linear, 3> m_edge = {};
  Linear m_value = {};
  Eigen::Vector3d m_low = Eigen::Vector3d::Zero(), m_high = Eigen::Vector3d::Zero();
};

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_TRIANGLE_SCAN_H
