// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_PARAVIEW_SCRIPT_H
#define PROGRAMS_SCENES_PARAVIEW_SCRIPT_H

#include "scenes/Shown_scene.h"

#include <string>

namespace Programs {

// A script in Python that shows what write_vtk() has written, in the folder in which it lies: the surface in the colours of
// its first field, features as spheres of their radius in the colours of their tau, and the times of both.
//
// `paraview --script=show_in_paraview.py` opens a window; `pvpython show_in_paraview.py PICTURE.png [TIME]` writes a picture.
// For ParaView 5.6 and later.
std::string paraview_script(const Shown_scene& scene);

} // namespace Programs

#endif // PROGRAMS_SCENES_PARAVIEW_SCRIPT_H
