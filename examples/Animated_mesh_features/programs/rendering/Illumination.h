// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_ILLUMINATION_H
#define PROGRAMS_RENDERING_ILLUMINATION_H

#include "rendering/Colour.h"
#include "rendering/Lights.h"
#include "rendering/Surface.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace Programs::Rendering {

// A place that is lit.
struct Shading_point
{
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // towards the camera's side, length 1
  Eigen::Vector3d to_eye = Eigen::Vector3d::Zero(); // length 1; zero: no highlights
  double least_cosine = 0;                          // of a light's direction and the normal; others are left out
};

// What arrives there.
struct Shading
{
  Colour diffuse = Colour::Zero();   // 1: as much as a surface of full brightness needs
  Colour highlight = Colour::Zero(); // mirrored, to be added
};

// Lets all lights fall on points, with the shadows that the surface casts; `centre` and `radius` are of a sphere around
// it, `map_size` is that of the lights' depth maps.
//
// Light by light, for all points: a depth map is used while it is in the cache, and forgotten. Takes
// O(lights (points + triangles)) time. The result does not depend on the number of threads.
std::vector<Shading> illuminated(const std::vector<Shading_point>& points, const Surface& surface,
                                 const Eigen::Vector3d& centre, double radius, const std::vector<Light>& lights,
                                 std::size_t map_size = 512);

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_ILLUMINATION_H
