// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PICTURES_PICTURE_OF_SCENE_H
#define PROGRAMS_PICTURES_PICTURE_OF_SCENE_H

#include "pictures/Picture_options.h"
#include "rendering/Image.h"
#include "scenes/Shown_scene.h"

namespace Programs {

// Draws a scene in some frames: the surface, coloured by the first of the scene's fields, and the features that live in
// the frame as translucent spheres of radius sqrt(2) sigma, blue where tau is long and red where it is short, as faint as
// `opacity_in_frame()` tells, with their ranks where there is room; outlines of those at a limit of the scales are
// dashed. Each frame has a panel of its own, with its number and time; a legend stands below. Unless a view is told,
// frames are seen from where `scene.views`, or else `scene_views()`, say: the best view, or another one of a frame of
// which it hides too much.
//
// The pictures are drawn by a renderer of our own (perspective, hidden parts by z-buffer, 16 samples a pixel averaged in
// linear light, soft shadows and ambient occlusion of 124 lights), without a display or a graphics processor; what is
// written on them, by cairo. The same bits whatever the number of threads. Takes O(frames (pixels + triangles)) time:
// about a second of a core for a frame of 9,000 vertices in 250,000 pixels; and 150 bytes for each pixel of the largest
// panel.
//
// throws Option_error if an option has a value that makes no sense for the scene, or a field has another shape;
// Input_error as `check_scene()`, or if there are no vertices; Output_error if cairo cannot draw.
Rendering::Srgb_image picture_of_scene(const Shown_scene& scene, const Picture_options& options = Picture_options());

} // namespace Programs

#endif // PROGRAMS_PICTURES_PICTURE_OF_SCENE_H
