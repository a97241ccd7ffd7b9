// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_READING_SEQUENCE_H
#define PROGRAMS_READING_SEQUENCE_H

#include "reading/Values.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Detection/Spatio_temporal_feature.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

// The animations of all programs, and features on them.

namespace Programs {

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef CGAL::Animated_mesh_features::Frame_sequence<Mesh, FT> Sequence;
typedef CGAL::Animated_mesh_features::Spatio_temporal_feature<Sequence::vertex_descriptor> Feature;

} // namespace Programs

#endif // PROGRAMS_READING_SEQUENCE_H
