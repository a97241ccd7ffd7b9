// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_SHOWN_SCENE_H
#define PROGRAMS_SCENES_SHOWN_SCENE_H

#include "scenes/Scene.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Detection/Spatio_temporal_feature.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace Programs {

// The scene of the programs: what draws is compiled for it, and for no other.
typedef CGAL::Animated_mesh_features::Frame_sequence<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>,
                                                     double>
    Shown_sequence;
typedef CGAL::Animated_mesh_features::Spatio_temporal_feature<Shown_sequence::vertex_descriptor> Shown_feature;
typedef CGAL::Animated_mesh_features::IO::Scene<Shown_sequence, Shown_feature> Shown_scene;

} // namespace Programs

#endif // PROGRAMS_SCENES_SHOWN_SCENE_H
