// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Panel_cameras.h"

#include <algorithm>

namespace Programs::Rendering {

Panel_cameras::Panel_cameras(const std::vector<Surface>& bodies, const std::vector<std::vector<Sphere>>& spheres,
                             const std::vector<View_direction>& views)
{
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto is_same = [&](const Side& s) {
      return s.view.azimuth == views[i].azimuth && s.view.elevation == views[i].elevation;
    };
    const auto side = std::find_if(m_sides.begin(), m_sides.end(), is_same);
    m_side_of_body.push_back(std::size_t(side - m_sides.begin()));
    if (side == m_sides.end()) m_sides.push_back({views[i], {}});
    std::vector<Eigen::Vector3d>& points = m_sides[m_side_of_body.back()].points;
    Eigen::Vector3d low = bodies[i].points.front(), high = low;
    for (const Eigen::Vector3d& p : bodies[i].points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    Eigen::Vector3d centre = (low + high) / 2;
    centre[views[i].up_axis] = 0; // all stand on the same ground
    m_centres.push_back(centre);
    for (const Eigen::Vector3d& p : bodies[i].points) points.push_back(p - centre);
    for (const Sphere& s : spheres[i])
      for (int axis = 0; axis < 3; ++axis)
        for (double side_of_sphere : {-1., 1.})
          points.push_back(s.centre - centre +
                           side_of_sphere * double(s.opacity) * s.radius * Eigen::Vector3d::Unit(axis));
  }
}

double Panel_cameras::aspect() const
{
  const double smallest = 1e-6; // of the image
  double width = smallest, height = smallest;
  for (const Side& side : m_sides) {
    const Camera any = fitted_camera(side.points, side.view, 1, 1, 1, 1);
    Eigen::Vector2d low = any.project(side.points.front()).head<2>(), high = low;
    for (const Eigen::Vector3d& p : side.points) {
      const Eigen::Vector2d q = any.project(p).head<2>();
      low = low.cwiseMin(q), high = high.cwiseMax(q);
    }
    // at the same distance from all
    const double scale = any.eye.dot(-any.forward);
    width = (std::max)(width, scale * (high - low)[0]), height = (std::max)(height, scale * (high - low)[1]);
  }
  return (std::min)(8., (std::max)(1. / 8, width / height));
}

Camera Panel_cameras::camera(std::size_t i, double width, double height, double room_width, double room_height) const
{
  const auto fitted = [&](const Side& side) {
    return fitted_camera(side.points, side.view, width, height, room_width, room_height);
  };
  Camera result = fitted(m_sides[m_side_of_body[i]]);
  double farthest = 0;
  for (std::size_t s = 0; s < m_sides.size(); ++s) {
    const Camera other = fitted(m_sides[s]);
    farthest = s == 0 ? -other.eye.dot(other.forward) : (std::max)(farthest, -other.eye.dot(other.forward));
  }
  result.eye -= (farthest + result.eye.dot(result.forward)) * result.forward;
  result.eye += m_centres[i];
  return result;
}

} // namespace Programs::Rendering
