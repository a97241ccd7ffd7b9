// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_LIGHTS_H
#define PROGRAMS_RENDERING_LIGHTS_H

#include "rendering/Colour.h"

#include <Eigen/Core>

#include <vector>

namespace Programs::Rendering {

// Light from infinitely far away. Soft light is made of many of them.
struct Light
{
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY(); // towards the light, length 1
  Colour colour = Colour::Zero();                       // irradiance of a surface that faces it
  bool is_highlight = false;                            // whether it is reflected as a highlight
  bool is_soft = false; // whether it is one of those from all around, whose shadows have no edges
};

// The lights of a studio: a large key light above one shoulder of the camera, a fill light at the other, a rim light
// behind the body, and a dome of dim light all around, whose shadows are what is called ambient occlusion. A white
// surface that faces the key light gets about 1. `up` and `to_camera` are unit vectors.
std::vector<Light> studio_lights(const Eigen::Vector3d& up, const Eigen::Vector3d& to_camera);

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_LIGHTS_H
