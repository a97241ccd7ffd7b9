// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_PANEL_CAMERAS_H
#define PROGRAMS_RENDERING_PANEL_CAMERAS_H

#include "rendering/Camera.h"
#include "rendering/Spheres.h"
#include "rendering/Surface.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace Programs::Rendering {

// The cameras of the panels of a picture: they see all bodies from the same distance, so that sizes can be compared, and
// follow them over the ground.
class Panel_cameras
{
public:
  // Measures the bodies, at least one, each with at least one point, and the spheres of each; faint ones need not be
  // seen as a whole.
  // from a direction for each body, all with the same up axis
  Panel_cameras(const std::vector<Surface>& bodies, const std::vector<std::vector<Sphere>>& spheres,
                const std::vector<View_direction>& views);

  // from the same direction for all
  Panel_cameras(const std::vector<Surface>& bodies, const std::vector<std::vector<Sphere>>& spheres,
                const View_direction& view)
    : Panel_cameras(bodies, spheres, std::vector<View_direction>(bodies.size(), view))
  {}

  // width by height of what is to be seen, roughly; between 1/8 and 8
  double aspect() const;

  // the camera of body `i`, for an image of which a rectangle in the middle is for the body
  Camera camera(std::size_t i, double width, double height, double room_width, double room_height) const;

private:
  // what is seen from one direction
  struct Side
  {
    View_direction view;
    std::vector<Eigen::Vector3d> points; // of all its bodies, from their centres
  };

  std::vector<Side> m_sides;
  std::vector<std::size_t> m_side_of_body;
  std::vector<Eigen::Vector3d> m_centres;
};

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_PANEL_CAMERAS_H
