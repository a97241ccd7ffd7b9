// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_WRITE_VTK_H
#define PROGRAMS_SCENES_WRITE_VTK_H

#include "scenes/Shown_scene.h"

#include <CGAL/Animated_mesh_features/IO/Output_folder.h>

#include <cstddef>
#include <string>

namespace Programs {

// The name of the file of a frame, as "surface_0007.vtp": with as many digits for all frames, so that they sort.
std::string vtp_name(const std::string& series, std::size_t frame, std::size_t number_of_frames);

// Writes a scene as two time series for ParaView and whatever else reads VTK's XML files.
//
// - `surface.pvd` with a `surface_0000.vtp` for each frame: the surface, with the fields of the scene as point data under
//   their names, in single precision, the first of them shown first, and with normals;
// - `features.pvd` with a `features_0000.vtp` for each frame: the features that live in it (see lives_in_frame()) as points
//   that move with the surface. Point data are `sigma`, `tau`, `time`, `strength`, `amplitude`, `fit` and `radius`, `opacity`
//   (see opacity_in_frame()), `vertex` and `frame` counted from 0, `rank`, `place` and `parent` counted from 1, 0 for no
//   parent, and `at_scale_limit`, 0 or 1. A frame in which no feature lives has a file without points;
// - `show_in_paraview.py`, which opens both in ParaView, see paraview_script().
//
// Times are in seconds from the first frame, lengths in the unit of the animation.
//
// By hand: open both; filter Glyph on the features, glyph type Sphere of radius 1, scaled by `radius` with scale factor 1, and
// all points.
//
// Every frame holds the connectivity: about 24 bytes for each of the vertices, 16 for each of the triangles, and 4 for each
// value of a field.
//
// The folder is written, but not committed.
// throws what check_scene() does if the scene does not fit together; Output_error if a file cannot be written, or a
// coordinate or a value exceeds single precision.
void write_vtk(CGAL::Animated_mesh_features::IO::Output_folder& folder, const Shown_scene& scene);

} // namespace Programs

#endif // PROGRAMS_SCENES_WRITE_VTK_H
