// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PLOTS_WRITE_VIEW_MAP_H
#define PROGRAMS_PLOTS_WRITE_VIEW_MAP_H

#include "drawing/Drawing_format.h"
#include "scenes/Shown_scene.h"

#include <ostream>

namespace Programs {

// Draws what each direction around a scene shows of its features: azimuth to the right, elevation upwards, as --view takes
// them, so that poles are lines; with the views that are chosen, `scene.views` or else scene_views(), and the elevations
// among which they are chosen. 642 directions are looked from, between which it is linear.
// throws as scene_views(); Output_error if cairo cannot draw.
void write_view_map(std::ostream& os, const Shown_scene& scene, Drawing_format format);

} // namespace Programs

#endif // PROGRAMS_PLOTS_WRITE_VIEW_MAP_H
