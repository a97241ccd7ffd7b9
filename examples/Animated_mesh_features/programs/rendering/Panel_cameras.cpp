// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Panel_cameras.h"

#include <algorithm>

namespace Programs::Rendering {

Panel_cameras::Panel_cameras(const std::vector<Surface>& bodies, const std::vector<std::vector<Sphere>>& spheres,
                             const View_direction& view)
  : m_view(view)
{
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Eigen::Vector3d low = bodies[i].points.front(), high = low;
    for (const Eigen::Vector3d& p : bodies[i].points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    Eigen::Vector3d centre = (low + high) / 2;
    centre[view.up_axis] = 0; // all stand on the same ground
    m_centres.push_back(centre);
    for (const Eigen::Vector3d& p : bodies[i].points) m_points.push_back(p - centre);
    for (const Sphere& s : spheres[i])
      for (int axis = 0; axis < 3; ++axis)
        for (double side : {-1., 1.})
          m_points.push_back(s.centre - centre + side * double(s.opacity) * s.radius * Eigen::Vector3d::Unit(axis));
  }
}

double Panel_cameras::aspect() const
{
  const Camera any = fitted_camera(m_points, m_view, 1, 1, 1, 1);
  double left = 0, right = 0, bottom = 0, top = 0;
  bool is_first = true;
  for (const Eigen::Vector3d& p : m_points) {
    const Eigen::Vector3d q = any.project(p);
    left = is_first ? q[0] : (std::min)(left, q[0]), right = is_first ? q[0] : (std::max)(right, q[0]);
    bottom = is_first ? q[1] : (std::min)(bottom, q[1]), top = is_first ? q[1] : (std::max)(top, q[1]);
    is_first = false;
  }
  const double smallest = 1e-6; // of the image
  const double ratio = (std::max)(smallest, right - left) / (std::max)(smallest, top - bottom);
  return (std::min)(8., (std::max)(1. / 8, ratio));
}

Camera Panel_cameras::camera(std::size_t i, double width, double height, double room_width, double room_height) const
{
  Camera result = fitted_camera(m_points, m_view, width, height, room_width, room_height);
  result.eye += m_centres[i];
  return result;
}

} // namespace Programs::Rendering
