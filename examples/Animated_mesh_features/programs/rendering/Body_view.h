// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_BODY_VIEW_H
#define PROGRAMS_RENDERING_BODY_VIEW_H

#include "rendering/Camera.h"
#include "rendering/Spheres.h"
#include "rendering/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace Programs::Rendering {

// The axis that probably points up, y (1) or z (2): the one on which the body stands more stably, and y if there is no
// clear difference. Files do not tell; animals and people at rest are told well, what does not stand is not.
int probable_up_axis(const std::vector<Eigen::Vector3d>& points);

// The azimuth (degrees) from which bodies, at least one, are seen well: 30 degrees beside the direction along which they
// are thinnest; of the four such directions the one from which more of the centres of their spheres are seen, weighted
// by their opacities. `view` gives the up axis and the elevation.
double good_azimuth(const std::vector<Surface>& bodies, const std::vector<std::vector<Sphere>>& spheres,
                    View_direction view);

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_BODY_VIEW_H
