// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_RENDER_H
#define PROGRAMS_RENDERING_RENDER_H

#include "rendering/Camera.h"
#include "rendering/Image.h"
#include "rendering/Spheres.h"
#include "rendering/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace Programs::Rendering {

// What is in a picture besides the surface.
struct Stage_set
{
  Eigen::Vector3d up = Eigen::Vector3d::UnitY(); // unit vector
  double ground = 0;                             // its height along `up`
  Colour background = Colour::Ones();            // of what is neither surface nor shadow
  Colour clay = Colour(0.80f, 0.78f, 0.74f);     // of a surface without values
  double line_width = 1.5;                       // around spheres, pixels
  std::vector<Sphere> spheres;                   // the features
};

// Draws a surface as it would look in a photographer's studio: lit by soft lights, standing on a ground, with translucent
// spheres. The image has the size of the camera's. The same bits whatever the number of threads.
Image render(const Surface& surface, const Camera& camera, const Stage_set& set);

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_RENDER_H
