// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_DEPTH_MAP_H
#define PROGRAMS_RENDERING_DEPTH_MAP_H

#include "rendering/Surface.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace Programs::Rendering {

// How far a surface reaches towards a light: tells which points are in its shadow.
class Depth_map
{
public:
  // Looks at a surface, which is not kept, from the light. `centre` and `radius` are of a sphere around the surface,
  // `to_light` is a unit vector, `size` the texels a side. An error of one of 512, 0.4 % of the body, is smaller than the
  // penumbra of any of the lights.
  Depth_map(const Surface& surface, const Eigen::Vector3d& centre, double radius, const Eigen::Vector3d& to_light,
            std::size_t size = 512);

  // A point of a surface as `visibility()` takes it: moved along its normal by one or two texels, since points on a
  // surface shadow themselves. The same for all maps of one size around one sphere.
  Eigen::Vector3f lifted(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const
  {
    return (point - m_centre + m_away * normal).cast<float>();
  }

  // How much of the light reaches a lifted point, 0 to 1, interpolated between texels; outside of the map there is no
  // shadow. Inline, because it is asked for every point and light.
  float visibility(const Eigen::Vector3f& lifted) const
  {
    const Eigen::Vector3f p = place(lifted) - Eigen::Vector3f(0.5f, 0.5f, 0);
    const float last = float(m_size - 1);
    if (!(p[0] >= 0 && p[1] >= 0 && p[0] < last && p[1] < last)) return 1;
    const int x = int(p[0]), y = int(p[1]);
    const float s = p[0] - float(x), t = p[1] - float(y), height = p[2];
    const float* const h = &m_height[std::size_t(y * m_size + x)];
    const auto is_lit = [height](float h) { return height >= h ? 1.f : 0.f; };
    return (1 - t) * ((1 - s) * is_lit(h[0]) + s * is_lit(h[1])) +
           t * ((1 - s) * is_lit(h[m_size]) + s * is_lit(h[m_size + 1]));
  }

  // The same for a point and the surface's normal there.
  float visibility(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const
  {
    return visibility(lifted(point, normal));
  }

private:
  // of what is seen from the centre; in texels, the third towards the light
  Eigen::Vector3f place(const Eigen::Vector3f& p) const
  {
    const float middle = float(m_size) / 2;
    return m_axes * p + Eigen::Vector3f(middle, middle, 0);
  }

  // `side` is 1 or -1 if only a triangle that shows this side counts, else 0.
  void draw(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c, int side);

  int m_size;
  Eigen::Vector3d m_centre;
  double m_scale; // texels in a unit of length
  double m_away;  // 1.5 texels: half the diagonal of the interpolated ones, for slopes of up to 45 degrees
  Eigen::Matrix3f m_axes; // in texels
  std::vector<float> m_height;
};

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_DEPTH_MAP_H
